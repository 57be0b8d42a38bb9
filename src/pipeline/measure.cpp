// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measure.h"

#include <fmt/format.h>

#include <algorithm>

namespace rimline::pipeline {
namespace {

// One per vertex. Fills take theirs from their own edges: they have no neighbours in the sample.
std::vector<double> spacing_of_vertices(const Work& work) {
  std::vector<double> spacing = work.spacing;
  const std::size_t points = spacing.size();
  if (points == work.vertices.size()) return spacing;
  std::vector<double> sum(work.vertices.size() - points, 0);
  std::vector<int> count(sum.size(), 0);
  for (const Triangle& t : work.triangles) {
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(t[c]);
      if (v < points) continue;
      sum[v - points] += distance(work.vertices[t[c]], work.vertices[t[(c + 1) % 3]]);
      ++count[v - points];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) spacing.push_back(sum[i] / std::max(count[i], 1));
  return spacing;
}

// A part of the mesh with vertices of its own.
struct Part {
  std::vector<Point> points;
  std::vector<double> spacing;
  std::vector<UV> uv;
  std::vector<Triangle> triangles;
};

// One for each component, its triangles in their order.
std::vector<Part> parts_of(const Work& work, const std::vector<double>& spacing, std::size_t count) {
  std::vector<Part> parts(count);
  std::vector<Index> local(work.vertices.size(), none), owner(work.vertices.size(), none);
  for (std::size_t t = 0; t < work.triangles.size(); ++t) {
    Part& part = parts[work.triangle_patch[t]];
    Triangle& own = part.triangles.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const Index v = work.triangles[t][c];
      if (owner[v] != work.triangle_patch[t]) {
        owner[v] = work.triangle_patch[t];
        local[v] = static_cast<Index>(part.points.size());
        part.points.push_back(work.vertices[v]);
        part.spacing.push_back(spacing[v]);
        part.uv.push_back(work.uv[v]);
      }
      own[c] = local[v];
    }
  }
  return parts;
}

// A single component is the whole.
void measure_components(Work& work, const std::vector<double>& spacing) {
  std::vector<ComponentSummary>& components = work.report.components;
  if (components.empty()) return;  // the paper's presets know one surface only
  for (std::size_t i = 0; i < components.size(); ++i)
    components[i].distortion = work.distortion.components[i];
  if (components.size() == 1) {
    components[0].mesh = work.report.mesh;
    return;
  }
  const std::vector<Part> parts = parts_of(work, spacing, components.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].triangles.empty()) continue;
    components[i].mesh =
        measure_mesh(parts[i].points, parts[i].triangles, parts[i].spacing, parts[i].uv, work.run);
  }
}

void measure_self_intersections(Work& work) {
  const auto pairs = find_self_intersections(work.vertices, work.triangles, work.run);
  work.report.self_intersections = pairs.size();
  if (work.report.components.empty()) return;
  for (const auto& [s, t] : pairs) {
    const Index a = work.triangle_patch[s], b = work.triangle_patch[t];
    ++work.report.components[a].self_intersections;
    if (a != b) ++work.report.components[b].self_intersections;
  }
}

// The same vertices: as many, in the same places but for the rounding of a file.
bool same_vertices(const Work& work, const std::vector<Point>& reference) {
  if (reference.size() < work.input.size()) return false;
  const double tolerance = 1e-3 * work.report.spacing.mean;
  for (std::size_t i = 0; i < work.input.size(); ++i) {
    const Point p = work.input[i];
    if (is_finite(p) && !(distance(p, reference[i]) <= tolerance)) return false;
  }
  return true;
}

// In ids of the input, which those of the reference are where its vertices are the same.
std::vector<Triangle> in_input_ids(const Work& work) {
  std::vector<Triangle> triangles = work.triangles;
  const auto used = static_cast<Index>(work.arrangement.ids.size());
  const auto beyond = static_cast<Index>(work.given.reference.points.size());
  for (Triangle& t : triangles) {
    for (Index& v : t) v = v < used ? work.arrangement.ids[v] : beyond + v;
  }
  return triangles;
}

void measure_reference(Work& work) {
  const Reference& given = work.given.reference;
  if (given.triangles.empty()) return;
  ReferenceSummary summary;
  summary.name = given.name;
  summary.points = given.points.size();
  summary.triangles = given.triangles.size();
  std::vector<Point> points;  // about the arrangement's origin
  for (const Point& p : given.points) points.push_back(p - work.arrangement.origin);
  for (const auto& [a, b, c] : given.triangles)
    summary.area += 0.5 * norm(cross(points[b] - points[a], points[c] - points[a]));
  const SurfaceDistance to_reference(points, given.triangles), to_mesh(work.vertices, work.triangles);
  summary.to_reference = to_reference.from(work.vertices, work.triangles, work.run);
  summary.from_reference = to_mesh.from(points, given.triangles, work.run);
  summary.hausdorff = std::max(summary.to_reference.most, summary.from_reference.most);
  if (same_vertices(work, given.points))
    summary.edges_agree = edge_agreement(in_input_ids(work), given.triangles);
  std::vector<std::vector<Triangle>> parts(work.report.components.size());
  for (std::size_t t = 0; t < work.triangles.size() && !parts.empty(); ++t)
    parts[work.triangle_patch[t]].push_back(work.triangles[t]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].empty()) continue;
    work.report.components[i].to_reference =
        parts.size() == 1 ? summary.to_reference : to_reference.from(work.vertices, parts[i], work.run);
  }
  work.report.reference = std::move(summary);
}

void report_unmeshed(Work& work) {
  Report& report = work.report;
  const std::size_t added = work.vertices.size() - work.arrangement.points.size();
  report.points.unmeshed = work.arrangement.points.size() + added - report.mesh.points_used;
  if (report.points.unmeshed == 0) return;
  const char* reason = work.is_paper()   ? "fell on others in the plane and are in no triangle"
                       : work.range_scan ? "hang together with no loop, or lie beside the surface that was "
                                           "scanned, and are in no triangle"
                                         : "hang together with no loop and are in no triangle";
  report.warnings.push_back(fmt::format("{} points {}", report.points.unmeshed, reason));
}

}  // namespace

void measure(Work& work) {
  work.clock.enter(Stage::Measure);
  Report& report = work.report;
  report.has_mesh = true;
  const std::vector<double> spacing = spacing_of_vertices(work);
  report.mesh = measure_mesh(work.vertices, work.triangles, spacing, work.uv, work.run);
  work.distortion = measure_distortion(work.vertices, work.triangles, work.uv, work.triangle_patch,
                                       report.components.size(), work.run);
  report.distortion = work.distortion.whole;
  measure_components(work, spacing);
  measure_self_intersections(work);
  measure_reference(work);
  report_unmeshed(work);
}

}  // namespace rimline::pipeline
