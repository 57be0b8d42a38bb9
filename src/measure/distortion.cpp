// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "mesh/corner_angles.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

// One triangle before its component's scale is known.
struct TriangleMap {
  double area = 0, uv_area = 0;  // uv_area without its sign
  double angle = 0;              // mean difference over the corners
  double square = 0, most = 0;   // of the singular values from uv to space: mean square, larger one squared
  double ratio = 0, log_ratio = 0;  // of the areas, once the scale is known; log_ratio without its sign
  double stretch = 0;               // the larger singular value, once the scale is known
};

// The map from uv to space is linear on the triangle; a, b, c are its metric in uv (Sander et al. 2001).
TriangleMap map_of(const std::array<Point, 3>& p, const std::array<UV, 3>& q) {
  TriangleMap map;
  const Point e = p[1] - p[0], f = p[2] - p[0];
  const UV s{q[1].u - q[0].u, q[1].v - q[0].v}, t{q[2].u - q[0].u, q[2].v - q[0].v};
  const double twice = s.u * t.v - s.v * t.u;
  map.area = 0.5 * norm(cross(e, f));
  map.uv_area = 0.5 * std::abs(twice);
  const auto flat = corner_angles({q[0].u, q[0].v, 0}, {q[1].u, q[1].v, 0}, {q[2].u, q[2].v, 0});
  const auto solid = corner_angles(p[0], p[1], p[2]);
  for (int i = 0; i < 3; ++i) map.angle += std::abs(flat[i] - solid[i]) / 3;
  const Point du = (1 / twice) * (t.v * e - s.v * f), dv = (1 / twice) * (s.u * f - t.u * e);
  const double a = dot(du, du), b = dot(du, dv), c = dot(dv, dv);
  map.square = (a + c) / 2;
  map.most = (a + c + std::sqrt((a - c) * (a - c) + 4 * b * b)) / 2;
  if (twice == 0 || !std::isfinite(map.most)) map.square = map.most = std::numeric_limits<double>::infinity();
  return map;
}

// Sums over the triangles of a component, or of all.
struct Sums {
  double area = 0, uv_area = 0;
  double angle = 0, log_ratio = 0, square = 0;
  double angle_most = 0, ratio_least = std::numeric_limits<double>::infinity(), ratio_most = 0, stretch = 0;
  bool any = false;

  DistortionSummary summary() const {
    if (!any || area == 0) return {};
    return {angle / area, angle_most, ratio_least, ratio_most, log_ratio / area, std::sqrt(square / area),
            stretch};
  }
};

void set_scale(double scale, TriangleMap& map) {
  map.ratio = map.area > 0 ? map.uv_area / map.area * scale * scale : 1;
  map.log_ratio = std::abs(std::log(map.ratio));
  map.square = map.square / (scale * scale);
  map.stretch = std::sqrt(map.most) / scale;
}

void add(const TriangleMap& map, Sums& sums) {
  sums.any = true;
  sums.angle += map.angle * map.area;
  sums.angle_most = std::max(sums.angle_most, map.angle);
  if (map.area == 0) return;  // without area there is no ratio
  sums.ratio_least = std::min(sums.ratio_least, map.ratio);
  sums.ratio_most = std::max(sums.ratio_most, map.ratio);
  sums.log_ratio += map.log_ratio * map.area;
  sums.square += map.square * map.area;
  sums.stretch = std::max(sums.stretch, map.stretch);
}

// In place of a triangle that has no uv.
constexpr TriangleMap unmapped{0, 0, std::numeric_limits<double>::quiet_NaN()};
bool is_unmapped(const TriangleMap& map) { return std::isnan(map.angle) && map.area == 0; }

bool has_place(UV p) { return std::isfinite(p.u) && std::isfinite(p.v); }

void resize(Distortion::Values& values, std::size_t count, float value) {
  for (auto* list : {&values.angle, &values.area, &values.stretch, &values.max_stretch})
    list->assign(count, value);
}

// The mean over the triangles of each point, in the order of the triangles. Points are taken in ranges, which
// may be worked on at the same time; each goes through all triangles, which costs less than lists would.
void spread_to_points(const std::vector<Triangle>& triangles, const std::vector<TriangleMap>& maps,
                      std::size_t points, const Run& run, Distortion& distortion) {
  constexpr std::size_t ranges = 4;
  const Distortion::Values& from = distortion.triangle;
  Distortion::Values& to = distortion.point;
  resize(to, points, 0);
  struct Sum {
    double weight = 0, angle = 0, area = 0, stretch = 0, max_stretch = 0;
  };
  parallel_tasks(ranges, Stage::Measure, run, [&](std::size_t r) {
    const std::size_t first = points * r / ranges, last = points * (r + 1) / ranges;
    std::vector<Sum> sums(last - first);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const double weight = maps[t].area;
      for (const Index v : triangles[t]) {
        const std::size_t at = static_cast<std::size_t>(v) - first;
        if (at >= sums.size() || weight == 0) continue;
        sums[at].weight += weight;
        sums[at].angle += weight * from.angle[t];
        sums[at].area += weight * from.area[t];
        sums[at].stretch += weight * from.stretch[t];
        sums[at].max_stretch += weight * from.max_stretch[t];
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const Sum& sum = sums[i];
      to.angle[first + i] = static_cast<float>(sum.angle / sum.weight);
      to.area[first + i] = static_cast<float>(sum.area / sum.weight);
      to.stretch[first + i] = static_cast<float>(sum.stretch / sum.weight);
      to.max_stretch[first + i] = static_cast<float>(sum.max_stretch / sum.weight);
    }
  });
}

}  // namespace

Distortion measure_distortion(Points points, const std::vector<Triangle>& triangles, std::span<const UV> uv,
                              std::span<const Index> component, std::size_t component_count, const Run& run,
                              const Seams& seams) {
  std::vector<TriangleMap> maps(triangles.size());
  parallel_for_each(triangles.size(), Stage::Measure, run, [&](Index t) {
    const auto& [a, b, c] = triangles[t];
    const auto at = [&](int corner) { return corner_uv(uv, seams, triangles, t, corner); };
    const std::array<UV, 3> q{at(0), at(1), at(2)};
    const bool placed = has_place(q[0]) && has_place(q[1]) && has_place(q[2]);
    maps[t] = placed ? map_of({points[a], points[b], points[c]}, q) : unmapped;
  });
  const auto component_of = [&](std::size_t t) { return component.empty() ? 0 : component[t]; };
  std::vector<Sums> parts(std::max<std::size_t>(component_count, 1));
  for (std::size_t t = 0; t < maps.size(); ++t) {
    parts[component_of(t)].area += maps[t].area;
    parts[component_of(t)].uv_area += maps[t].uv_area;
  }
  Distortion result;
  Sums whole;
  for (const Sums& part : parts) whole.area += part.area;
  resize(result.triangle, triangles.size(), 0);
  parallel_for_each(triangles.size(), Stage::Measure, run, [&](Index t) {
    if (is_unmapped(maps[t])) {
      constexpr float nan = std::numeric_limits<float>::quiet_NaN();
      for (auto* values : {&result.triangle.angle, &result.triangle.area, &result.triangle.stretch,
                           &result.triangle.max_stretch})
        (*values)[t] = nan;
      return;
    }
    const Sums& part = parts[component_of(t)];
    const double scale = part.uv_area > 0 ? std::sqrt(part.area / part.uv_area) : 1;
    result.triangle.stretch[t] = static_cast<float>(std::sqrt(maps[t].square) / scale);
    set_scale(scale, maps[t]);
    result.triangle.angle[t] = static_cast<float>(maps[t].angle);
    result.triangle.area[t] = static_cast<float>(maps[t].ratio);
    result.triangle.max_stretch[t] = static_cast<float>(maps[t].stretch);
  });
  for (std::size_t t = 0; t < maps.size(); ++t) {
    if (is_unmapped(maps[t])) continue;
    add(maps[t], parts[component_of(t)]);
    add(maps[t], whole);
  }
  spread_to_points(triangles, maps, points.size(), run, result);
  result.whole = whole.summary();
  for (const Sums& part : parts) result.components.push_back(part.summary());
  return result;
}

}  // namespace rimline
