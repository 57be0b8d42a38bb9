// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measure_reference.h"

#include <algorithm>

#include "base/vec.h"

namespace rimline::pipeline {
namespace {

// Whether the vertices are the same: as many, at the same positions to the rounding of a file.
bool same_vertices(const PreparedPoints& prepared, const std::vector<Point>& reference) {
  const Points input = prepared.input;
  if (reference.size() < input.size()) return false;
  const double tolerance = 1e-3 * prepared.spacing_summary.mean;
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (is_finite(input[i]) && !(distance(input[i], reference[i]) <= tolerance)) return false;
  }
  return true;
}

// In ids of the input, which those of the reference are where its vertices are the same.
std::vector<Triangle> in_ids_of_reference(std::vector<Triangle> triangles, const std::vector<Index>& ids,
                                          std::size_t reference_points) {
  const auto used = static_cast<Index>(ids.size());
  const auto beyond = static_cast<Index>(reference_points);
  for (Triangle& t : triangles) {
    for (Index& v : t) v = v < used ? ids[v] : beyond + v;
  }
  return triangles;
}

double area_of(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += 0.5 * norm(triangle_normal(points[a], points[b], points[c]));
  return area;
}

// The triangles of each component.
std::vector<std::vector<Triangle>> triangles_of_components(const MappedMesh& mesh) {
  std::vector<std::vector<Triangle>> parts(mesh.components.size());
  for (std::size_t t = 0; t < mesh.triangles.size() && !parts.empty(); ++t)
    parts[mesh.triangle_patch[t]].push_back(mesh.triangles[t]);
  return parts;
}

}  // namespace

ReferenceMeasures measure_reference(const PreparedPoints& prepared, const MappedMesh& mesh,
                                    const Reference& reference, const Run& run) {
  ReferenceMeasures measures;
  if (reference.triangles.empty()) return measures;
  std::vector<Point> points;  // about the arrangement's origin
  for (const Point& p : reference.points) points.push_back(p - prepared.arrangement.origin);
  ReferenceSummary summary;
  summary.name = reference.name;
  summary.points = points.size();
  summary.triangles = reference.triangles.size();
  summary.area = area_of(points, reference.triangles);
  const SurfaceDistance to_reference(points, reference.triangles), to_mesh(mesh.vertices, mesh.triangles);
  summary.to_reference = to_reference.from(mesh.vertices, mesh.triangles, run);
  summary.from_reference = to_mesh.from(points, reference.triangles, run);
  summary.hausdorff = std::max(summary.to_reference.most, summary.from_reference.most);
  if (same_vertices(prepared, reference.points)) {
    summary.edges_agree = edge_agreement(
        in_ids_of_reference(mesh.triangles, prepared.ids(), reference.points.size()), reference.triangles);
  }
  const auto parts = triangles_of_components(mesh);
  for (const auto& part : parts) {
    std::optional<DistanceSummary>& distances = measures.components.emplace_back();
    if (part.empty()) continue;
    distances = parts.size() == 1 ? summary.to_reference : to_reference.from(mesh.vertices, part, run);
  }
  measures.whole = std::move(summary);
  return measures;
}

}  // namespace rimline::pipeline
