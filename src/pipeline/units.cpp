// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/units.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/domain_traits.h"
#include "points/far_points.h"

namespace rimline::pipeline {
namespace {

constexpr int usual = 32;  // exponents of extents that are left alone

// Exact except where the result is out of the range of a double.
void scale(double& value, int exponent) { value = std::ldexp(value, exponent); }
void scale(Point& p, int exponent) {
  for (double* x : {&p.x, &p.y, &p.z}) scale(*x, exponent);
}
// As above; a finite point far from most others stays finite.
void scale_input(std::vector<Point>& points, int exponent) {
  constexpr double most = std::numeric_limits<double>::max();
  for (Point& p : points) {
    if (!is_finite(p)) continue;
    scale(p, exponent);
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::clamp(*x, -most, most);
  }
}
void scale(UV& p, int exponent) {
  for (double* x : {&p.u, &p.v}) scale(*x, exponent);
}
template <class T>
void scale(std::vector<T>& items, int exponent) {
  for (T& item : items) scale(item, exponent);
}
void scale(DistanceSummary& d, int exponent) {
  for (double* x : {&d.mean, &d.rms, &d.most}) scale(*x, exponent);
}
void scale(SpacingSummary& s, int exponent) {
  for (double* x : {&s.mean, &s.least, &s.most, &s.low, &s.high}) scale(*x, exponent);
}

// The exponent of half the extent of the finite points that are not far (the extent itself may overflow); 0
// where they coincide.
int exponent_of(Points points, const Run& run) {
  PointBox all, box;
  for (const Point& p : points) {
    if (is_finite(p)) all.add(p);
  }
  const PointBox near = box_without_far_points(points, all, run).value_or(all);
  for (const Point& p : points) {
    if (near.has(p)) box.add(p);
  }
  const double half = std::max({0.5 * box.high.x - 0.5 * box.low.x, 0.5 * box.high.y - 0.5 * box.low.y,
                                0.5 * box.high.z - 0.5 * box.low.z});
  return half > 0 ? std::ilogb(half) : 0;
}

void scale_report(Report& report, int exponent) {
  scale(report.spacing, exponent);
  for (double* x : {&report.steps.x, &report.steps.y, &report.steps.z, &report.steps.removed})
    scale(*x, exponent);
  for (Loop& loop : report.loops) scale(loop.length, exponent);
  scale(report.mesh.area, 2 * exponent);
  if (report.holes) {
    for (FilledHole& hole : report.holes->filled) scale(hole.length, exponent);
  }
  if (report.reference) {
    scale(report.reference->area, 2 * exponent);
    scale(report.reference->hausdorff, exponent);
    scale(report.reference->to_reference, exponent);
    scale(report.reference->from_reference, exponent);
  }
  for (ComponentSummary& component : report.components) {
    scale(component.mesh.area, 2 * exponent);
    scale(component.seams, exponent);
    scale(component.low, exponent);
    scale(component.high, exponent);
    for (HandleRepair& repair : component.repairs) {
      scale(repair.place, exponent);
      scale(repair.length, exponent);
    }
    if (component.to_reference) scale(*component.to_reference, exponent);
  }
  for (LeftOut& part : report.left_out) {
    scale(part.low, exponent);
    scale(part.high, exponent);
  }
}

// For a map at the scale of the surface; other maps have size 1.
void scale_map(std::vector<UV>& uv, const Scaled& scaled) {
  const ParameterizeOptions& map = scaled.options.map;
  const bool of_domain = map.uv_scale == UvScale::Domain && traits(map.domain).released;
  if (of_domain || map.uv_scale == UvScale::Real) scale(uv, scaled.exponent);
}

}  // namespace

std::optional<Scaled> scaled_to_unit(Points points, const Options& options, const Given& given,
                                     const Run& run) {
  const int exponent = exponent_of(points, run);
  if (std::abs(exponent) <= usual) return std::nullopt;
  Scaled scaled{exponent, {points.begin(), points.end()}, options, given};
  scale_input(scaled.points, -exponent);
  scale(scaled.given.reference.points, -exponent);
  if (scaled.given.viewpoint) scale(*scaled.given.viewpoint, -exponent);
  scale(scaled.options.mesh.holes.most_length, -exponent);
  return scaled;
}

BoundaryResult in_input_unit(BoundaryResult result, const Scaled& scaled, const Options& options) {
  for (Loop& loop : result.loops) scale(loop.length, scaled.exponent);
  scale_report(result.report, scaled.exponent);
  result.report.options = options;
  return result;
}

ParameterizeResult in_input_unit(ParameterizeResult result, const Scaled& scaled, const Options& options) {
  result.boundary = in_input_unit(std::move(result.boundary), scaled, options);
  scale_map(result.uv, scaled);
  return result;
}

ReconstructResult in_input_unit(ReconstructResult result, const Scaled& scaled, const Options& options) {
  result.boundary = in_input_unit(std::move(result.boundary), scaled, options);
  scale_map(result.uv, scaled);
  scale_map(result.seams.uv, scaled);
  scale(result.added, scaled.exponent);
  return result;
}

}  // namespace rimline::pipeline
