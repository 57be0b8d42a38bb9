// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/fill_rim.h"

#include <cmath>

#include "base/vec.h"
#include "map/graph.h"
#include "map/weights.h"
#include "mesh/flip.h"
#include "mesh/triangulation.h"

namespace rimline {
namespace {

double area_of(Points points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += 0.5 * norm(triangle_normal(points[a], points[b], points[c]));
  return sum;
}

class Fill {
 public:
  Fill(Points rim, Triangulation mesh, const MayJoin& may_join, const Run& run)
      : rim_(static_cast<Index>(rim.size())),
        points_(rim.begin(), rim.end()),
        mesh_(std::move(mesh)),
        // New vertices have no edges outside the fill.
        may_join_([this, &may_join](Index a, Index b) { return a >= rim_ || b >= rim_ || may_join(a, b); }),
        run_(run) {}
  Fill(const Fill&) = delete;

  void flip() { flip_edges(points_, mesh_, run_, may_join_); }

  // Splits triangles at their centres where these are far from all three corners by the local size.
  void add_points(std::span<const double> spacing, std::size_t most) {
    size_.assign(spacing.begin(), spacing.end());
    coarsen(most);
    constexpr int rounds = 40;  // each round at least halves the triangles' area; far fewer are ever needed
    for (int round = 0; round < rounds && split_large(most); ++round) flip();
  }

  // The membrane: every added vertex becomes the mean of its neighbours, weighted by the shapes of the
  // triangles. In the plane all stay where they are.
  void relax() {
    if (added() == 0) return;
    std::vector<WeightedEdge> edges;
    for (Index t = 0; t < mesh_.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        const Index other = mesh_.adjacent[t][c];
        if (other < t) continue;  // rim edges have no weight; other edges are added from the other side
        const Triangle& v = mesh_.triangles[t];
        edges.push_back({v[next(c)], v[previous(c)], cotangent_weight(points_, mesh_, t, c, {})});
      }
    }
    const Graph graph = make_graph(static_cast<Index>(points_.size()), edges);
    std::vector<char> fixed(points_.size(), 0);
    std::fill(fixed.begin(), fixed.begin() + rim_, 1);
    std::vector<UV> xy, z;
    for (const Point& p : points_) {
      xy.push_back({p.x, p.y});
      z.push_back({p.z, 0});
    }
    constexpr double enough = 1e-9;
    solve_map(graph, fixed, enough, xy, run_);
    solve_map(graph, fixed, enough, z, run_);
    for (std::size_t i = static_cast<std::size_t>(rim_); i < points_.size(); ++i)
      points_[i] = {xy[i].u, xy[i].v, z[i].u};
  }

  RimFill take() && {
    return {std::move(mesh_.triangles), std::vector<Point>(points_.begin() + rim_, points_.end())};
  }

 private:
  std::size_t added() const { return points_.size() - static_cast<std::size_t>(rim_); }

  // A vertex of six equilateral triangles has sqrt(3) / 2 of its squared spacing for itself.
  void coarsen(std::size_t most) {
    double mean = 0;
    for (const double s : size_) mean += s / static_cast<double>(size_.size());
    const double wanted = area_of(points_, mesh_.triangles) / (0.87 * mean * mean);
    const double scale = std::sqrt(wanted / static_cast<double>(std::max<std::size_t>(most, 1)));
    if (!(scale > 1)) return;
    for (double& s : size_) s *= scale;
  }

  bool split_large(std::size_t most) {
    const Index count = mesh_.size();
    bool any = false;
    for (Index t = 0; t < count && added() < most; ++t) {
      const Triangle v = mesh_.triangles[t];
      const Point centre = (1.0 / 3) * (points_[v[0]] + points_[v[1]] + points_[v[2]]);
      const double size = (size_[v[0]] + size_[v[1]] + size_[v[2]]) / 3;
      bool large = true;
      for (const Index i : v) {
        const double apart = std::sqrt(2.0) * distance(centre, points_[i]);
        large = large && apart > size && apart > size_[i];
      }
      if (!large) continue;
      split(mesh_, t, static_cast<Index>(points_.size()));
      points_.push_back(centre);
      size_.push_back(size);
      any = true;
    }
    return any;
  }

  Index rim_;
  std::vector<Point> points_;
  std::vector<double> size_;  // desired triangle size at each point
  Triangulation mesh_;
  MayJoin may_join_;
  const Run& run_;
};

}  // namespace

RimFill fill_rim(Points rim, std::span<const double> spacing, std::size_t most_added, const MayJoin& may_join,
                 const Run& run) {
  run.check_cancel();
  std::vector<Triangle> triangles = triangulate_polygon(rim, may_join);
  if (triangles.empty()) return {};
  const auto count = static_cast<Index>(rim.size());
  Fill fill(rim, triangulation_of(std::move(triangles), count), may_join, run);
  fill.flip();
  if (!spacing.empty()) {
    fill.add_points(spacing, most_added);
    fill.relax();
    fill.flip();
  }
  return std::move(fill).take();
}

}  // namespace rimline
