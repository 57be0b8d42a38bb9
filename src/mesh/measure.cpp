// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/union_find.h"
#include "base/vec.h"
#include "mesh/corner_angles.h"
#include "mesh/corners.h"

namespace rimline {
namespace {

Point in_space(UV p) { return {p.u, p.v, 0}; }

// Contribution of a slice of the vertices to the summary.
struct VertexCounts {
  std::size_t used = 0, edges = 0, boundary_edges = 0, nonmanifold_edges = 0, long_edges = 0, split = 0;
  std::vector<std::array<Index, 2>> boundary;
};

// Each edge is counted at its lower end.
VertexCounts count_slice(Points points, const Corners& corners, std::span<const double> spacing,
                         std::size_t begin, std::size_t end) {
  VertexCounts counts;
  Vertex vertex;
  for (Index v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
    const auto own = corners.of(v);
    if (own.empty()) continue;
    ++counts.used;
    counts.split += vertex.visit(own, [&](Index other, std::size_t triangles) {
      if (other < v) return;
      ++counts.edges;
      if (triangles == 1) counts.boundary.push_back({v, other});
      counts.nonmanifold_edges += triangles > 2;
      const double longest = 3 * std::max(spacing[v], spacing[other]);
      counts.long_edges += triangles == 2 && distance(points[v], points[other]) > longest;
    }) > 1;
  }
  counts.boundary_edges = counts.boundary.size();
  return counts;
}

// The number of connected sets of boundary edges.
std::size_t count_pieces(const std::vector<VertexCounts>& slices, std::size_t points) {
  UnionFind pieces(points);
  std::vector<char> seen(points, 0);
  std::size_t vertices = 0, joins = 0;
  for (const VertexCounts& slice : slices) {
    for (const auto& [a, b] : slice.boundary) {
      vertices += !std::exchange(seen[a], 1);
      vertices += !std::exchange(seen[b], 1);
      joins += pieces.join(a, b);
    }
  }
  return vertices - joins;
}

// The number of used points less the number of components.
std::size_t count_joins(const std::vector<Triangle>& triangles, std::size_t points) {
  UnionFind components(points);
  std::size_t joins = 0;
  for (const auto& [a, b, c] : triangles) {
    joins += components.join(a, b);
    joins += components.join(b, c);
  }
  return joins;
}

// Contribution of a slice of the triangles to the summary.
struct TriangleSums {
  std::array<std::size_t, 12> min_angle_histogram{};
  double area = 0, distortion = 0;
  std::size_t uv_flips = 0, mapped = 0;
};

bool has_place(UV p) { return std::isfinite(p.u) && std::isfinite(p.v); }

// The positions of triangle corners in the map.
struct Map {
  std::span<const UV> uv;  // empty: none
  const Seams& seams;
};

TriangleSums sum_slice(Points points, std::span<const Triangle> triangles, std::size_t begin, std::size_t end,
                       const Map& map) {
  TriangleSums sums;
  for (std::size_t t = begin; t < end; ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto angles = corner_angles(points[a], points[b], points[c]);
    const double degrees = *std::min_element(angles.begin(), angles.end()) * 180 / std::numbers::pi;
    ++sums.min_angle_histogram[std::min(11, static_cast<int>(degrees / 5))];
    sums.area += 0.5 * norm(triangle_normal(points[a], points[b], points[c]));
    if (map.uv.empty()) continue;
    const auto at = [&](int corner) { return corner_uv(map.uv, map.seams, triangles, t, corner); };
    const UV ua = at(0), ub = at(1), uc = at(2);
    if (!has_place(ua) || !has_place(ub) || !has_place(uc)) continue;
    ++sums.mapped;
    const Point pa = in_space(ua), pb = in_space(ub), pc = in_space(uc);
    sums.uv_flips += !(cross(pb - pa, pc - pa).z > 0);
    const auto flat = corner_angles(pa, pb, pc);
    for (int i = 0; i < 3; ++i) sums.distortion += std::abs(angles[i] - flat[i]);
  }
  return sums;
}

constexpr std::size_t slice_size = 8192;  // of the sums: it does not depend on the number of threads
std::size_t slice_count(std::size_t count) { return (count + slice_size - 1) / slice_size; }

void measure_triangles(Points points, std::span<const Triangle> triangles, const Map& map, const Run& run,
                       MeshSummary& summary) {
  std::vector<TriangleSums> slices(slice_count(triangles.size()));
  parallel_tasks(slices.size(), Stage::Measure, run, [&](std::size_t k) {
    const std::size_t begin = k * slice_size;
    slices[k] = sum_slice(points, triangles, begin, std::min(begin + slice_size, triangles.size()), map);
  });
  double distortion = 0;
  std::size_t mapped = 0;
  for (const TriangleSums& slice : slices) {
    for (std::size_t i = 0; i < slice.min_angle_histogram.size(); ++i)
      summary.min_angle_histogram[i] += slice.min_angle_histogram[i];
    summary.area += slice.area;
    summary.uv_flips += slice.uv_flips;
    distortion += slice.distortion;
    mapped += slice.mapped;
  }
  if (mapped > 0) {
    summary.mean_angle_distortion = distortion / (3.0 * static_cast<double>(mapped));
    // A mesh that was turned to face `up` is mirrored in uv as a whole; that is no fold.
    summary.uv_flips = std::min(summary.uv_flips, mapped - summary.uv_flips);
  }
}

void measure_vertices(Points points, const Corners& corners, std::span<const double> spacing, const Run& run,
                      MeshSummary& summary) {
  std::vector<VertexCounts> slices(slice_count(points.size()));
  parallel_tasks(slices.size(), Stage::Measure, run, [&](std::size_t k) {
    slices[k] =
        count_slice(points, corners, spacing, k * slice_size, std::min(points.size(), (k + 1) * slice_size));
  });
  for (const VertexCounts& slice : slices) {
    summary.points_used += slice.used;
    summary.edges += slice.edges;
    summary.boundary_edges += slice.boundary_edges;
    summary.nonmanifold_edges += slice.nonmanifold_edges;
    summary.long_edges += slice.long_edges;
    summary.nonmanifold_vertices += slice.split;
  }
  summary.boundary_loops = count_pieces(slices, points.size());
}

}  // namespace

MeshSummary measure_mesh(Points points, const std::vector<Triangle>& triangles,
                         std::span<const double> spacing, std::span<const UV> uv, const Run& run,
                         const Seams& seams) {
  MeshSummary summary;
  summary.triangles = triangles.size();
  // One thread each, at the same time.
  std::optional<Corners> corners;
  std::size_t joins = 0;
  parallel_tasks(2, Stage::Measure, run, [&](std::size_t task) {
    if (task == 0) {
      corners.emplace(triangles, points.size());
    } else {
      joins = count_joins(triangles, points.size());
    }
  });
  run.check_cancel();
  measure_vertices(points, *corners, spacing, run, summary);
  summary.euler = static_cast<long long>(summary.points_used) - static_cast<long long>(summary.edges) +
                  static_cast<long long>(triangles.size());
  summary.components = summary.points_used - joins;
  measure_triangles(points, triangles, {uv, seams}, run, summary);
  return summary;
}

SpacingSummary summarize_spacing(std::vector<double> spacing, const Run& run) {
  if (spacing.empty()) return {};
  const double mean =
      std::accumulate(spacing.begin(), spacing.end(), 0.0) / static_cast<double>(spacing.size());
  const auto [least, most] = std::minmax_element(spacing.begin(), spacing.end());
  SpacingSummary summary{mean, *least, *most, 0, 0};
  std::vector<double> copy(spacing);
  const auto quantile = [](std::vector<double>& values, double q) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * (values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  parallel_tasks(2, Stage::Measure, run.without_progress(), [&](std::size_t task) {
    if (task == 0) {
      summary.low = quantile(spacing, 0.05);
    } else {
      summary.high = quantile(copy, 0.95);
    }
  });
  run.check_cancel();
  return summary;
}

}  // namespace rimline
