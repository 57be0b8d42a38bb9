// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/vec.h"
#include "measure/triangle_tree.h"
#include "mesh/edges.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

// Squared distance to a segment.
double to_segment(Point p, Point a, Point b) {
  const Point e = b - a;
  const double length = dot(e, e);
  const double t = length > 0 ? std::clamp(dot(p - a, e) / length, 0.0, 1.0) : 0;
  return squared_distance(p, a + t * e);
}

// Squared distance to a triangle: to its plane where the foot lies inside, else to the nearest side.
double to_triangle(Point p, Point a, Point b, Point c) {
  const Point normal = triangle_normal(a, b, c);
  const double size = dot(normal, normal);
  const auto inside = [&](Point from, Point to) { return dot(cross(to - from, p - from), normal) >= 0; };
  if (size > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    const double height = dot(p - a, normal);
    return height * height / size;
  }
  return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

}  // namespace

struct SurfaceDistance::Tree {
  Points points;
  const std::vector<Triangle>& triangles;
  TriangleTree tree;
};

SurfaceDistance::SurfaceDistance(Points points, const std::vector<Triangle>& triangles)
    : tree_(new Tree{points, triangles, TriangleTree(points, triangles, Run{.threads = 1})}) {
  if (triangles.empty()) throw Error(ErrorCode::BadOption, "the reference has no triangles");
}

SurfaceDistance::~SurfaceDistance() = default;

double SurfaceDistance::to(Point place) const {
  const auto& nodes = tree_->tree.nodes();
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, Index>> open = {{nodes.front().box.squared_distance(place), 0}};
  while (!open.empty()) {
    const auto [bound, id] = open.back();
    open.pop_back();
    if (bound >= least) continue;
    const TriangleTree::Node& node = nodes[id];
    if (node.is_leaf()) {
      for (Index i = node.begin; i < node.end; ++i) {
        const auto& [a, b, c] = tree_->triangles[tree_->tree.order()[i]];
        least = std::min(least, to_triangle(place, tree_->points[a], tree_->points[b], tree_->points[c]));
      }
      continue;
    }
    std::pair<double, Index> near{nodes[node.left].box.squared_distance(place), node.left};
    std::pair<double, Index> far{nodes[node.right].box.squared_distance(place), node.right};
    if (far.first < near.first) std::swap(near, far);
    open.push_back(far);  // the nearer is looked at first
    open.push_back(near);
  }
  return std::sqrt(least);
}

DistanceSummary SurfaceDistance::from(Points points, const std::vector<Triangle>& triangles,
                                      const Run& run) const {
  if (triangles.empty()) return {};
  // Per triangle: its centre counts for its whole, edges and vertices as often as triangles have them.
  constexpr std::size_t places = 7;
  std::vector<std::array<double, places>> distances(triangles.size());
  parallel_for_each(triangles.size(), Stage::Measure, run, [&](Index t) {
    const Point a = points[triangles[t][0]], b = points[triangles[t][1]], c = points[triangles[t][2]];
    const std::array<Point, places> at{
        (1.0 / 3) * (a + b + c), a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)};
    for (std::size_t i = 0; i < places; ++i) distances[t][i] = to(at[i]);
  });
  // Over a triangle the mean of a quadratic is 1/20 of each corner, 2/15 of each middle and 9/20 of the
  // centre (exact to the third degree).
  constexpr std::array<double, places> weight{9.0 / 20, 1.0 / 20, 1.0 / 20, 1.0 / 20,
                                              2.0 / 15, 2.0 / 15, 2.0 / 15};
  DistanceSummary summary;
  double area = 0, sum = 0, squares = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const double own = 0.5 * norm(triangle_normal(points[a], points[b], points[c]));
    area += own;
    for (std::size_t i = 0; i < places; ++i) {
      const double d = distances[t][i];
      sum += own * weight[i] * d;
      squares += own * weight[i] * d * d;
      summary.most = std::max(summary.most, d);
    }
  }
  if (area > 0) {
    summary.mean = sum / area;
    summary.rms = std::sqrt(squares / area);
  }
  return summary;
}

double edge_agreement(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  const std::vector<Edge> ours = edges_of(a), theirs = edges_of(b);
  if (ours.empty() && theirs.empty()) return 1;
  const auto before = [](const Edge& e, const Edge& f) { return e.a != f.a ? e.a < f.a : e.b < f.b; };
  std::size_t both = 0, i = 0, j = 0;
  while (i < ours.size() && j < theirs.size()) {
    const bool less = before(ours[i], theirs[j]), more = before(theirs[j], ours[i]);
    both += !less && !more;
    i += !more;
    j += !less;
  }
  return 2.0 * static_cast<double>(both) / static_cast<double>(ours.size() + theirs.size());
}

}  // namespace rimline
