// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/vec.h"
#include "mesh/constrained_delaunay.h"
#include "rimline/run.h"

namespace rimline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_for_least_area = 200;

// Corners of a polygon, some of those of the whole.
using Corners = std::vector<Index>;

// Least area over a polygon. In a plane all triangulations without overlap have the same area; a small share
// of the squared sides then prefers compact triangles, and avoids triangles without area.
class LeastArea {
 public:
  LeastArea(Points points, const Corners& corners, const MayJoin& may_join)
      : points_(points),
        corners_(corners),
        may_join_(may_join),
        n_(corners.size()),
        cost_(n_ * n_, infinite),
        apex_(n_ * n_, 0) {}

  // False where no triangulation is allowed.
  bool solve(std::vector<Triangle>& triangles) {
    for (std::size_t i = 0; i + 1 < n_; ++i) cost_[at(i, i + 1)] = 0;
    for (std::size_t span = 2; span < n_; ++span) {
      for (std::size_t i = 0; i + span < n_; ++i) close(i, i + span);
    }
    if (cost_[at(0, n_ - 1)] == infinite) return false;
    collect(triangles);
    return true;
  }

 private:
  std::size_t at(std::size_t i, std::size_t j) const { return i * n_ + j; }

  void close(std::size_t i, std::size_t j) {
    const bool is_side = i == 0 && j == n_ - 1;
    if (!is_side && !may_join_(corners_[i], corners_[j])) return;
    for (std::size_t k = i + 1; k < j; ++k) {
      const double sum = cost_[at(i, k)] + cost_[at(k, j)];
      if (sum >= cost_[at(i, j)]) continue;
      const double cost = sum + triangle_cost(corners_[i], corners_[k], corners_[j]);
      if (cost >= cost_[at(i, j)]) continue;
      cost_[at(i, j)] = cost;
      apex_[at(i, j)] = static_cast<Index>(k);
    }
  }

  double triangle_cost(Index a, Index b, Index c) const {
    constexpr double compact = 1e-4;
    const Point e = points_[b] - points_[a], f = points_[c] - points_[a], g = f - e;
    return 0.5 * norm(cross(e, f)) + compact * (dot(e, e) + dot(f, f) + dot(g, g));
  }

  void collect(std::vector<Triangle>& triangles) const {
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j == i + 1) continue;
      const auto k = static_cast<std::size_t>(apex_[at(i, j)]);
      triangles.push_back({corners_[i], corners_[k], corners_[j]});
      open.emplace_back(i, k);
      open.emplace_back(k, j);
    }
  }

  Points points_;
  const Corners& corners_;
  const MayJoin& may_join_;
  std::size_t n_;
  std::vector<double> cost_;  // of the polygon i, i + 1, ..., j
  std::vector<Index> apex_;   // of its triangle at the side i j
};

// Least area of a polygon of every m-th corner, and of the polygons between them likewise.
bool divide(Points points, const Corners& corners, const MayJoin& may_join,
            std::vector<Triangle>& triangles) {
  if (corners.size() <= most_for_least_area) {
    return LeastArea(points, corners, may_join).solve(triangles);
  }
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(corners.size())));
  const std::size_t step = corners.size() / std::min(root, most_for_least_area) + 1;
  Corners coarse;
  std::vector<Corners> between;
  for (std::size_t first = 0; first < corners.size(); first += step) {
    coarse.push_back(corners[first]);
    Corners part;
    for (std::size_t i = first; i <= std::min(first + step, corners.size()); ++i)
      part.push_back(corners[i % corners.size()]);
    if (part.size() > 2) between.push_back(std::move(part));
  }
  if (!LeastArea(points, coarse, may_join).solve(triangles)) return false;
  return std::all_of(between.begin(), between.end(), [&](const Corners& part) {
    return may_join(part.front(), part.back()) && divide(points, part, may_join, triangles);
  });
}

// The corners in the plane that the polygon's vector area is normal to (Newell), counter-clockwise.
std::vector<UV> laid_flat(Points corners) {
  Point area;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point next = corners[next_in(i, corners.size())];
    area = area + cross(corners[i] - corners[0], next - corners[0]);
  }
  if (norm(area) == 0) return {};
  const Point normal = (1 / norm(area)) * area;
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const Point axis = x <= y && x <= z ? Point{1, 0, 0} : y <= z ? Point{0, 1, 0} : Point{0, 0, 1};
  const Point side = cross(axis, normal);
  const Point right = (1 / norm(side)) * side, up = cross(normal, right);
  std::vector<UV> flat;
  for (const Point& p : corners) flat.push_back({dot(p - corners[0], right), dot(p - corners[0], up)});
  return flat;
}

// Empty where the projected polygon crosses itself, or a pair must not be joined.
std::vector<Triangle> triangulate_flat(Points corners, const MayJoin& may_join) {
  const std::vector<UV> flat = laid_flat(corners);
  if (flat.empty()) return {};
  Loop rim;
  rim.points.resize(corners.size());
  std::iota(rim.points.begin(), rim.points.end(), 0);
  std::vector<Triangle> triangles;
  try {
    triangles = constrained_delaunay(flat, {rim});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::NotADisc) throw;
    return {};
  }
  if (triangles.size() != corners.size() - 2) return {};
  const auto n = static_cast<Index>(corners.size());
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[next_in(c, 3)];
      if ((a + 1) % n != b && (b + 1) % n != a && !may_join(a, b)) return {};
    }
  }
  return triangles;
}

}  // namespace

std::vector<Triangle> triangulate_polygon(Points corners, const MayJoin& may_join) {
  std::vector<Triangle> triangles;
  if (corners.size() > most_for_least_area) triangles = triangulate_flat(corners, may_join);
  if (!triangles.empty()) return triangles;
  Corners all(corners.size());
  std::iota(all.begin(), all.end(), 0);
  if (!divide(corners, all, may_join, triangles)) triangles.clear();
  return triangles;
}

}  // namespace rimline
