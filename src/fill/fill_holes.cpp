// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/fill_holes.h"

#include <algorithm>

#include "fill/fill_rim.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

// The edges between points of rims; no fill may repeat one.
class RimEdges {
 public:
  RimEdges(std::size_t points, const Triangulation& mesh, const std::vector<Loop>& loops) {
    std::vector<char> on_rim(points, 0);
    for (const Loop& loop : loops) {
      for (const Index v : loop.points) on_rim[v] = 1;
    }
    for (const Triangle& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) {
        if (on_rim[t[c]] && on_rim[t[next(c)]]) edges_.push_back(key(t[c], t[next(c)]));
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  bool allows(Index a, Index b) const {
    return a != b && !std::binary_search(edges_.begin(), edges_.end(), key(a, b));
  }

  // The edges of a fill are forbidden to the next one.
  void add(const std::vector<Triangle>& triangles, Index points) {
    const std::size_t before = edges_.size();
    for (const Triangle& t : triangles) {
      for (int c = 0; c < 3; ++c) {
        if (t[c] < points && t[next(c)] < points) edges_.push_back(key(t[c], t[next(c)]));
      }
    }
    const auto middle = edges_.begin() + static_cast<std::ptrdiff_t>(before);
    std::sort(middle, edges_.end());
    std::inplace_merge(edges_.begin(), middle, edges_.end());
  }

 private:
  static std::pair<Index, Index> key(Index a, Index b) { return std::minmax(a, b); }

  std::vector<std::pair<Index, Index>> edges_;
};

}  // namespace

bool is_filled(Points points, const Loop& rim, const HolePolicy& policy) {
  if (!policy.fill || rim.kind == LoopKind::Outer) return false;
  if (policy.most_points > 0) return static_cast<std::int64_t>(rim.points.size()) <= policy.most_points;
  return policy.most_length == 0 || loop_length(points, rim.points) <= policy.most_length;
}

HoleFills fill_holes(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                     std::span<const double> spacing, const RefineOptions& options, const Run& run) {
  HoleFills result;
  RimEdges edges(points.size(), mesh, loops);
  for (const Loop& loop : loops) {
    if (&loop == &loops.front() || !is_filled(points, loop, options.holes)) {
      result.loops.push_back(loop);
      continue;
    }
    // The surface is on the left of a loop, the fill on its right.
    const std::vector<Index> rim(loop.points.rbegin(), loop.points.rend());
    std::vector<Point> corners;
    std::vector<double> sizes;
    for (const Index v : rim) {
      corners.push_back(points[v]);
      if (options.fill_points) sizes.push_back(spacing[v]);
    }
    const auto may_join = [&](Index a, Index b) { return edges.allows(rim[a], rim[b]); };
    // At most as many new vertices as the patch has: more would be invented surface.
    RimFill fill = fill_rim(corners, sizes, points.size(), may_join, run);
    const auto corner_count = static_cast<Index>(rim.size());
    const auto first_added = static_cast<Index>(points.size() + result.added.size());
    for (Triangle& t : fill.triangles) {
      for (Index& v : t) v = v < corner_count ? rim[v] : first_added + (v - corner_count);
    }
    if (fill.triangles.empty()) result.loops.push_back(loop);
    edges.add(fill.triangles, static_cast<Index>(points.size()));
    result.triangles.insert(result.triangles.end(), fill.triangles.begin(), fill.triangles.end());
    result.added.insert(result.added.end(), fill.added.begin(), fill.added.end());
    result.fills.push_back({loop.points, fill.triangles.size(), fill.added.size()});
  }
  return result;
}

}  // namespace rimline
