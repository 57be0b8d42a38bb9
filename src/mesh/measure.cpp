// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/edges.h"
#include "union_find.h"

namespace rimline {
namespace {

double angle_between(Point a, Point b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

std::array<double, 3> corner_angles(Point a, Point b, Point c) {
  return {angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)};
}

Point in_space(UV p) { return {p.u, p.v, 0}; }

// Vertices whose triangles do not form one fan: corners at a vertex are joined across shared edges, and a
// vertex with more than one group of corners is not manifold.
std::size_t count_nonmanifold_vertices(const std::vector<Triangle>& triangles, std::size_t points) {
  struct Side {
    Index low, high, corner_low, corner_high;  // corners (3 * triangle + place) at the two ends
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index corner = static_cast<Index>(3 * t + c), next = static_cast<Index>(3 * t + (c + 1) % 3);
      const Index a = triangles[t][c], b = triangles[t][(c + 1) % 3];
      sides.push_back(a < b ? Side{a, b, corner, next} : Side{b, a, next, corner});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return x.low != y.low ? x.low < y.low : x.high != y.high ? x.high < y.high : x.corner_low < y.corner_low;
  });
  UnionFind corners(3 * triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high) continue;
    corners.join(sides[i].corner_low, sides[i - 1].corner_low);
    corners.join(sides[i].corner_high, sides[i - 1].corner_high);
  }
  std::vector<Index> fan_of(points, none);
  std::vector<char> split(points, 0);
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    const Index vertex = triangles[corner / 3][corner % 3], fan = corners.find(static_cast<Index>(corner));
    if (fan_of[vertex] == none) fan_of[vertex] = fan;
    if (fan_of[vertex] != fan) split[vertex] = 1;
  }
  return std::count(split.begin(), split.end(), 1);
}

// Groups of vertices that the edges connect, over the vertices that have an edge.
std::size_t count_groups(const std::vector<Edge>& edges, std::size_t points, bool boundary_only) {
  UnionFind groups(points);
  std::size_t vertices = 0, joins = 0;
  std::vector<char> seen(points, 0);
  for (const Edge& e : edges) {
    if (boundary_only && e.triangles != 1) continue;
    for (const Index v : {e.a, e.b}) {
      vertices += !seen[v];
      seen[v] = 1;
    }
    joins += groups.join(e.a, e.b);
  }
  return vertices - joins;
}

void measure_triangles(Points points, const std::vector<Triangle>& triangles, std::span<const UV> uv,
                       MeshSummary& summary) {
  double distortion = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto angles = corner_angles(points[a], points[b], points[c]);
    const double degrees = *std::min_element(angles.begin(), angles.end()) * 180 / std::numbers::pi;
    ++summary.min_angle_histogram[std::min(11, static_cast<int>(degrees / 5))];
    summary.area += 0.5 * norm(cross(points[b] - points[a], points[c] - points[a]));
    if (uv.empty()) continue;
    const Point pa = in_space(uv[a]), pb = in_space(uv[b]), pc = in_space(uv[c]);
    summary.uv_flips += !(cross(pb - pa, pc - pa).z > 0);
    const auto flat = corner_angles(pa, pb, pc);
    for (int i = 0; i < 3; ++i) distortion += std::abs(angles[i] - flat[i]);
  }
  if (!uv.empty() && !triangles.empty()) {
    summary.mean_angle_distortion = distortion / (3.0 * static_cast<double>(triangles.size()));
    // A mesh that was turned to face `up` is mirrored in uv as a whole, which is no fold.
    summary.uv_flips = std::min(summary.uv_flips, triangles.size() - summary.uv_flips);
  }
}

}  // namespace

MeshSummary measure_mesh(Points points, const std::vector<Triangle>& triangles,
                         std::span<const double> spacing, std::span<const UV> uv) {
  MeshSummary summary;
  summary.triangles = triangles.size();
  std::vector<char> used(points.size(), 0);
  for (const Triangle& t : triangles) {
    for (const Index v : t) used[v] = 1;
  }
  summary.points_used = std::count(used.begin(), used.end(), 1);

  const std::vector<Edge> edges = edges_of(triangles);
  summary.edges = edges.size();
  for (const Edge& e : edges) {
    summary.boundary_edges += e.triangles == 1;
    summary.nonmanifold_edges += e.triangles > 2;
    const double longest = 3 * std::max(spacing[e.a], spacing[e.b]);
    summary.long_edges += e.triangles == 2 && distance(points[e.a], points[e.b]) > longest;
  }
  summary.euler = static_cast<long long>(summary.points_used) - static_cast<long long>(edges.size()) +
                  static_cast<long long>(triangles.size());
  summary.components = count_groups(edges, points.size(), false);
  summary.boundary_loops = count_groups(edges, points.size(), true);
  summary.nonmanifold_vertices = count_nonmanifold_vertices(triangles, points.size());
  measure_triangles(points, triangles, uv, summary);
  return summary;
}

SpacingSummary summarize_spacing(std::vector<double> spacing) {
  if (spacing.empty()) return {};
  std::sort(spacing.begin(), spacing.end());
  const auto quantile = [&](double q) { return spacing[static_cast<std::size_t>(q * (spacing.size() - 1))]; };
  return {std::accumulate(spacing.begin(), spacing.end(), 0.0) / static_cast<double>(spacing.size()),
          spacing.front(), spacing.back(), quantile(0.05), quantile(0.95)};
}

}  // namespace rimline
