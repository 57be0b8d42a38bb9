// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/quantile.h"
#include "base/vec.h"
#include "pipeline/component_parts.h"
#include "pipeline/measure_reference.h"
#include "pipeline/warnings.h"

namespace rimline::pipeline {
namespace {

// Upper bound of the count: on a badly damaged surface counting all would take longer than everything else.
constexpr std::size_t most_self_intersections = 100'000;

// One per vertex. New vertices of fills have no neighbours in the sample; their spacing comes from their
// edges.
std::vector<double> spacing_of_vertices(std::vector<double> spacing, const MappedMesh& mesh) {
  const std::size_t points = spacing.size();
  if (points == mesh.vertices.size()) return spacing;
  std::vector<double> sum(mesh.vertices.size() - points, 0);
  std::vector<int> count(sum.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(t[c]);
      if (v < points) continue;
      sum[v - points] += distance(mesh.vertices[t[c]], mesh.vertices[t[next_in(c, 3)]]);
      ++count[v - points];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) spacing.push_back(sum[i] / std::max(count[i], 1));
  return spacing;
}

// A component with vertices of its own.
struct Part {
  std::vector<Point> points;
  std::vector<double> spacing;
  std::vector<UV> uv;
  std::vector<Triangle> triangles;
  Seams seams;
};

// Gives each part the positions of its corners; corners at a seam have their own.
void share_seams(const MappedMesh& mesh, std::vector<Part>& parts) {
  std::vector<std::size_t> seen(parts.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Part& part = parts[mesh.triangle_patch[t]];
    Triangle corners = part.triangles[seen[mesh.triangle_patch[t]]++];
    for (int c = 0; c < 3; ++c) {
      if (mesh.seams.corners[t][c] == mesh.triangles[t][c]) continue;
      part.seams.point.push_back(corners[c]);
      corners[c] = static_cast<Index>(part.points.size() + part.seams.uv.size());
      part.seams.uv.push_back(corner_uv(mesh.uv, mesh.seams, mesh.triangles, t, c));
    }
    part.seams.corners.push_back(corners);
  }
}

// One for each component, its triangles in their order.
std::vector<Part> parts_of(const MappedMesh& mesh, const std::vector<double>& spacing) {
  std::vector<Part> parts;
  for (ComponentPart& own : component_parts(mesh)) {
    Part& part = parts.emplace_back();
    part.triangles = std::move(own.triangles);
    for (const Index v : own.vertices) {
      part.points.push_back(mesh.vertices[v]);
      part.spacing.push_back(spacing[v]);
      part.uv.push_back(mesh.uv[v]);
    }
  }
  if (!mesh.seams.empty()) share_seams(mesh, parts);
  return parts;
}

// One for each component; none where the method knows one surface only. A single component is the whole.
std::vector<MeshSummary> measure_parts(const MappedMesh& mesh, const std::vector<double>& spacing,
                                       const MeshSummary& whole, const Run& run) {
  if (mesh.components.empty()) return {};
  if (mesh.components.size() == 1) return {whole};
  std::vector<MeshSummary> summaries;
  for (const Part& part : parts_of(mesh, spacing)) {
    summaries.push_back(part.triangles.empty() ? MeshSummary{}
                                               : measure_mesh(part.points, part.triangles, part.spacing,
                                                              part.uv, run, part.seams));
  }
  return summaries;
}

using Pairs = std::vector<std::array<Index, 2>>;

// For each component the number of pairs with a triangle of it.
std::vector<std::size_t> count_intersections(const Pairs& pairs, const MappedMesh& mesh) {
  std::vector<std::size_t> counts(mesh.components.size(), 0);
  if (counts.empty()) return counts;
  for (const auto& [s, t] : pairs) {
    const Index a = mesh.triangle_patch[s], b = mesh.triangle_patch[t];
    ++counts[a];
    if (a != b) ++counts[b];
  }
  return counts;
}

double longest_edge(const MappedMesh& mesh) {
  double longest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point p = mesh.vertices[a], q = mesh.vertices[b], r = mesh.vertices[c];
    longest = std::max({longest, squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
  }
  return std::sqrt(longest);
}

// The boxes of the components, in the coordinates of the input.
std::vector<std::pair<Point, Point>> boxes_of(const MappedMesh& mesh, Point origin) {
  std::vector<std::pair<Point, Point>> boxes(mesh.components.size());
  std::vector<char> begun(boxes.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size() && !boxes.empty(); ++t) {
    auto& [low, high] = boxes[mesh.triangle_patch[t]];
    for (const Index v : mesh.triangles[t]) {
      const Point p = mesh.vertices[v] + origin;
      if (!std::exchange(begun[mesh.triangle_patch[t]], 1)) low = high = p;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return boxes;
}

std::vector<std::string> warn_of_unmeshed(std::size_t unmeshed, const MappedMesh& mesh) {
  if (unmeshed == 0) return {};
  return {fmt::format("{} points {}", unmeshed, mesh.unmeshed)};
}

}  // namespace

Measures measure(const PreparedPoints& prepared, const MappedMesh& mesh, const Reference& reference,
                 const Run& run, StageClock& clock) {
  clock.enter(Stage::Measure);
  const std::vector<double> spacing = spacing_of_vertices(prepared.spacing, mesh);
  Measures measures;
  measures.mesh = measure_mesh(mesh.vertices, mesh.triangles, spacing, mesh.uv, run, mesh.seams);
  measures.distortion = measure_distortion(mesh.vertices, mesh.triangles, mesh.uv, mesh.triangle_patch,
                                           mesh.components.size(), run, mesh.seams);
  const std::vector<MeshSummary> parts = measure_parts(mesh, spacing, measures.mesh, run);
  const Pairs pairs = find_self_intersections(mesh.vertices, mesh.triangles, run, most_self_intersections);
  const std::vector<std::size_t> intersections = count_intersections(pairs, mesh);
  const std::vector<std::pair<Point, Point>> boxes = boxes_of(mesh, prepared.arrangement.origin);
  const ReferenceMeasures distances = measure_reference(prepared, mesh, reference, run);
  measures.self_intersections = pairs.size();
  measures.more_self_intersections = pairs.size() == most_self_intersections;
  measures.longest_edge = longest_edge(mesh) / median(prepared.spacing);
  measures.components = mesh.components;
  for (std::size_t i = 0; i < measures.components.size(); ++i) {
    ComponentSummary& component = measures.components[i];
    component.mesh = parts[i];
    std::tie(component.low, component.high) = boxes[i];
    component.distortion = measures.distortion.components[i];
    component.self_intersections = intersections[i];
    if (distances.whole) component.to_reference = distances.components[i];
  }
  measures.reference = distances.whole;
  measures.unmeshed = mesh.vertices.size() - measures.mesh.points_used;
  measures.warnings = warn_of_unmeshed(measures.unmeshed, mesh);
  for (std::string& warning : warn_of_long_edges(measures.longest_edge))
    measures.warnings.push_back(std::move(warning));
  return measures;
}

}  // namespace rimline::pipeline
