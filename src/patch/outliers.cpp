// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/outliers.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "base/vec.h"
#include "mesh/components.h"
#include "mesh/foot.h"

namespace rimline {
namespace {

// The triangles that are edge-connected to one at a loop. Triangles that touch the rim in a point alone are
// left out.
std::vector<Triangle> sheet_at(const std::vector<Index>& loop_next, const std::vector<Triangle>& triangles) {
  const Triangulation mesh = triangulation_of(triangles, static_cast<Index>(loop_next.size()));
  const Components components = find_components(mesh);
  std::vector<char> is_at_loop(components.count(), 0);
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (loop_next[triangles[t][c]] == triangles[t][next(c)]) is_at_loop[components.of_triangle[t]] = 1;
    }
  }
  std::vector<Triangle> sheet;
  for (Index t = 0; t < mesh.size(); ++t) {
    if (is_at_loop[components.of_triangle[t]]) sheet.push_back(triangles[t]);
  }
  return sheet;
}

class Finder {
 public:
  Finder(Points points, const std::vector<Loop>& loops, const std::vector<Triangle>& triangles)
      : points_(points), loop_next_(points.size(), none), on_loop_(points.size(), 0) {
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        loop_next_[loop.points[i]] = loop.points[next_in(i, loop.points.size())];
        on_loop_[loop.points[i]] = 1;
      }
    }
    triangles_ = sheet_at(loop_next_, triangles);
    std::vector<char> has(points.size(), 0);
    for (const Triangle& t : triangles_) has[t[0]] = has[t[1]] = has[t[2]] = 1;
    for (Index v = 0; v < static_cast<Index>(points.size()); ++v) {
      if (!has[v] && !on_loop_[v]) loose_.push_back(v);
    }
  }

  std::vector<Index> find(const Neighbours& neighbours) {
    gather(neighbours);
    std::vector<Index> found;
    for (const Index v : loose_) {
      if (is_beside(v, neighbours)) found.push_back(v);
    }
    return found;
  }

 private:
  static constexpr int looked_at = 12;  // neighbours: two rings of them

  // Gathers the triangles of all points near a loose one.
  void gather(const Neighbours& neighbours) {
    for (const Index v : loose_) {
      for (const Index near : neighbours.of(v, std::min(neighbours.k, looked_at))) stars_[near];
    }
    if (stars_.empty()) return;
    for (Index t = 0; t < static_cast<Index>(triangles_.size()); ++t) {
      for (const Index v : triangles_[t]) {
        const auto at = stars_.find(v);
        if (at != stars_.end()) at->second.push_back(t);
      }
    }
  }

  bool is_beside(Index v, const Neighbours& neighbours) const {
    Foot nearest;
    Index at = none;
    for (const Index near : neighbours.of(v, std::min(neighbours.k, looked_at))) {
      for (const Index t : stars_.at(near)) {
        const Triangle& x = triangles_[t];
        const Foot foot = foot_on(points_[v], {points_[x[0]], points_[x[1]], points_[x[2]]});
        if (foot.squared < nearest.squared) {
          nearest = foot;
          at = t;
        }
      }
    }
    if (at == none) return true;
    if (nearest.corner < 0) return false;
    // At a corner of the rim any of its triangles may be the nearest.
    const Index a = triangles_[at][next(nearest.corner)], b = triangles_[at][previous(nearest.corner)];
    if (loop_next_[a] == b || loop_next_[b] == a) return true;
    const double to_a = squared_distance(points_[v], points_[a]),
                 to_b = squared_distance(points_[v], points_[b]);
    constexpr double same = 1 + 1e-9;
    return (on_loop_[a] && to_a <= same * nearest.squared) || (on_loop_[b] && to_b <= same * nearest.squared);
  }

  Points points_;
  std::vector<Triangle> triangles_;
  std::vector<Index> loop_next_;
  std::vector<char> on_loop_;
  std::vector<Index> loose_;
  std::unordered_map<Index, std::vector<Index>> stars_;
};

}  // namespace

std::vector<Index> points_beside(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                                 const std::vector<Triangle>& triangles) {
  return Finder(points, loops, triangles).find(neighbours);
}

}  // namespace rimline
