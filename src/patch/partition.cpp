// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/partition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/union_find.h"
#include "base/vec.h"
#include "mesh/triangulation.h"

namespace rimline {
namespace {

constexpr Index shared = -2;  // where loops touch

// The loop of each point, none, or `shared`.
std::vector<Index> loops_of_points(const Separated& outline, Index point_count) {
  std::vector<Index> loop_of(point_count, none);
  for (Index l = 0; l < static_cast<Index>(outline.loops.size()); ++l) {
    for (const Index v : outline.loops[l].points) {
      if (v < point_count) loop_of[v] = l;
    }
  }
  for (const Index v : outline.original) loop_of[v] = shared;
  return loop_of;
}

bool names(const Stars& stars, Index from, Index to) {
  const std::span<const Index> star = stars[from];
  return std::find(star.begin(), star.end(), to) != star.end();
}

void join_mutual(const Stars& stars, const std::vector<Index>& loop_of, UnionFind& parts) {
  for (Index i = 0; i < static_cast<Index>(loop_of.size()); ++i) {
    if (loop_of[i] == shared) continue;
    for (const Index j : stars[i]) {
      if (j <= i || loop_of[j] == shared) continue;
      if (loop_of[i] != none && loop_of[j] != none) continue;  // cells at a rim reach over gaps
      if (names(stars, j, i)) parts.join(i, j);
    }
  }
}

// Closed parts: a closed surface of V points has 2 V triangles, an open one has fewer by the points of its
// rim, at least 3.5 sqrt(V). Gaps may account for half of that.
std::vector<Index> closed_parts(const std::vector<Triangle>& triangles, const std::vector<Index>& loop_of,
                                UnionFind& parts) {
  constexpr double gaps = 1.75;
  std::vector<Index> count(loop_of.size(), 0), found;
  for (const Triangle& t : triangles) ++count[parts.find(t[0])];
  for (Index v = 0; v < static_cast<Index>(loop_of.size()); ++v) {
    if (parts.find(v) != v || count[v] == 0) continue;
    const double points = parts.size_of(v);
    if (2 * points - count[v] <= gaps * std::sqrt(points)) found.push_back(v);
  }
  return found;
}

// By the first point of each part: those with a loop, and closed ones.
std::vector<char> bounded_parts(const std::vector<Index>& loop_of, const std::vector<Loop>& loops,
                                const std::vector<Triangle>& triangles, UnionFind& parts) {
  const Index n = static_cast<Index>(loop_of.size());
  std::vector<char> bounded(n, 0);
  for (const Index part : closed_parts(triangles, loop_of, parts)) bounded[part] = 1;
  for (const Loop& loop : loops) {
    for (const Index v : loop.points) {
      if (v < n && loop_of[v] != shared) bounded[parts.find(v)] = 1;
    }
  }
  return bounded;
}

bool any_loose(const std::vector<Index>& loop_of, const std::vector<Loop>& loops,
               const std::vector<Triangle>& triangles, UnionFind& parts) {
  const std::vector<char> bounded = bounded_parts(loop_of, loops, triangles, parts);
  for (Index i = 0; i < static_cast<Index>(loop_of.size()); ++i) {
    if (loop_of[i] != shared && !bounded[parts.find(i)]) return true;
  }
  return false;
}

// Joins points that are connected to no loop to points that are, where the cell of one names the other. Where
// `within` is given, its sets are joined as a whole.
void join_one_sided(const Stars& stars, const std::vector<Index>& loop_of, const std::vector<Loop>& loops,
                    const std::vector<Triangle>& triangles, UnionFind* within, UnionFind& parts) {
  const Index n = static_cast<Index>(loop_of.size());
  for (bool again = true; again;) {
    again = false;
    std::vector<char> bounded = bounded_parts(loop_of, loops, triangles, parts);
    for (Index i = 0; i < n; ++i) {
      if (loop_of[i] == shared) continue;
      for (const Index j : stars[i]) {
        if (j == none || loop_of[j] == shared) continue;
        const Index a = parts.find(i), b = parts.find(j);
        if (bounded[a] == bounded[b]) continue;
        // A part as large as the one that it would join is a surface of its own.
        const Index loose = bounded[a] ? b : a, firm = bounded[a] ? a : b;
        const bool together = within != nullptr ? within->find(i) == within->find(j)
                                                : 2 * parts.size_of(loose) <= parts.size_of(firm);
        if (!together) continue;
        parts.join(a, b);
        bounded[parts.find(a)] = 1;
        again = true;
      }
    }
  }
}

bool alone(Index v, const std::vector<Index>& loop_of) {
  return v < static_cast<Index>(loop_of.size()) && loop_of[v] != shared;
}

void join_along(std::span<const Index> points, const std::vector<Index>& loop_of, UnionFind& parts) {
  Index last = none;
  for (const Index v : points) {
    if (!alone(v, loop_of)) continue;
    if (last != none) parts.join(last, v);
    last = v;
  }
}

// The part of a loop, or none where it touches others in all of its points.
Index part_of(const Loop& loop, const std::vector<Index>& loop_of, UnionFind& parts) {
  for (const Index v : loop.points) {
    if (alone(v, loop_of)) return parts.find(v);
  }
  return none;
}

// Whether two outer loops are in one part. Components that touch in a point cause that.
bool any_two_outer(const std::vector<Loop>& loops, const std::vector<Index>& loop_of, UnionFind& parts) {
  std::vector<Index> found;
  for (const Loop& loop : loops) {
    const Index part = part_of(loop, loop_of, parts);
    if (loop.kind == LoopKind::Outer && part != none) found.push_back(part);
  }
  std::sort(found.begin(), found.end());
  return std::adjacent_find(found.begin(), found.end()) != found.end();
}

// The triangle of each directed edge, sorted; the last of several.
class DirectedEdges {
 public:
  struct Edge {
    Index from, to, triangle;
    auto operator<=>(const Edge&) const = default;
  };

  explicit DirectedEdges(const std::vector<Triangle>& triangles) {
    edges_.reserve(3 * triangles.size());
    for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
      for (int c = 0; c < 3; ++c) edges_.push_back({triangles[t][c], triangles[t][next(c)], t});
    }
    std::ranges::sort(edges_);
  }

  const std::vector<Edge>& all() const { return edges_; }
  // None where no triangle has the edge.
  Index triangle_at(Index from, Index to) const {
    const auto after = std::ranges::upper_bound(edges_, std::pair(from, to), {},
                                                [](const Edge& e) { return std::pair(e.from, e.to); });
    if (after == edges_.begin() || (after - 1)->from != from || (after - 1)->to != to) return none;
    return (after - 1)->triangle;
  }

 private:
  std::vector<Edge> edges_;
};

// As join_along() for each triangle, but a point belongs to one edge-connected component of triangles: to the
// one with an edge of a loop at the point, else to the one with most triangles there.
void join_by_sheets(const std::vector<Triangle>& triangles, const std::vector<Loop>& loops,
                    const std::vector<Index>& loop_of, UnionFind& parts) {
  const Index n = static_cast<Index>(loop_of.size());
  UnionFind sheets(triangles.size());
  const DirectedEdges edges(triangles);
  for (const auto& [from, to, t] : edges.all()) {
    const Index other = edges.triangle_at(to, from);
    if (other != none) sheets.join(edges.triangle_at(from, to), other);
  }
  std::map<std::pair<Index, Index>, Index> count;  // of triangles, by point and sheet
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (const Index v : triangles[t]) ++count[{v, sheets.find(t)}];
  }
  std::vector<Index> sheet_of(n, none), most(n, 0);
  for (const auto& [key, triangles_there] : count) {
    const auto [v, sheet] = key;
    if (triangles_there <= most[v]) continue;
    most[v] = triangles_there;
    sheet_of[v] = sheet;
  }
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Index a = loop.points[i], b = loop.points[next_in(i, loop.points.size())];
      const Index at = edges.triangle_at(a, b);
      if (at == none) continue;
      for (const Index v : {a, b}) {
        if (v < n) sheet_of[v] = sheets.find(at);
      }
    }
  }
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    std::vector<Index> own;
    for (const Index v : triangles[t]) {
      if (sheet_of[v] == sheets.find(t)) own.push_back(v);
    }
    join_along(own, loop_of, parts);
  }
  for (const Loop& loop : loops) join_along(loop.points, loop_of, parts);
  // A component without a loop joins the first one with a loop that it touches.
  for (bool again = true; again;) {
    again = false;
    std::vector<char> bounded = bounded_parts(loop_of, loops, triangles, parts);
    for (const Triangle& t : triangles) {
      for (int c = 0; c < 3; ++c) {
        const Index v = t[c], w = t[next(c)];
        if (!alone(v, loop_of) || !alone(w, loop_of)) continue;
        const Index a = parts.find(v), b = parts.find(w);
        if (bounded[a] == bounded[b]) continue;
        parts.join(a, b);
        bounded[parts.find(a)] = 1;
        again = true;
      }
    }
  }
}

// Translates the loops' points to ids of the patch: a point that they visit again gets a copy.
void make_local(const Separated& whole, Index point_count, PatchInput& patch) {
  std::map<Index, char> passed;
  for (Loop& loop : patch.outline.loops) {
    for (Index& v : loop.points) {
      const Index original = v < point_count ? v : whole.original[v - point_count];
      const auto at = std::lower_bound(patch.points.begin(), patch.points.end(), original);
      v = static_cast<Index>(at - patch.points.begin());
      if (!passed.emplace(original, 1).second) {
        patch.outline.original.push_back(v);
        v = static_cast<Index>(patch.points.size() + patch.outline.original.size()) - 1;
      }
    }
  }
}

}  // namespace

Partition partition(Index n, const std::function<const Stars&()>& stars, const std::vector<Loop>& loops,
                    const std::vector<Triangle>& surface) {
  const Separated outline = separate_pinches(loops, n);
  const std::vector<Index> loop_of = loops_of_points(outline, n);
  UnionFind parts(n);
  if (surface.empty()) join_mutual(stars(), loop_of, parts);
  for (const Triangle& t : surface) join_along(t, loop_of, parts);
  for (const Loop& loop : outline.loops) join_along(loop.points, loop_of, parts);
  if (any_loose(loop_of, outline.loops, surface, parts))
    join_one_sided(stars(), loop_of, outline.loops, surface, nullptr, parts);
  if (!surface.empty() && any_two_outer(outline.loops, loop_of, parts)) {
    UnionFind before = std::exchange(parts, UnionFind(n));
    join_by_sheets(surface, outline.loops, loop_of, parts);
    if (any_loose(loop_of, outline.loops, surface, parts))
      join_one_sided(stars(), loop_of, outline.loops, surface, &before, parts);
  }

  Partition result;
  std::vector<Index> patch_of(n, none);  // by part
  for (const Loop& loop : outline.loops) {
    const Index part = part_of(loop, loop_of, parts);
    Index patch = part == none ? none : patch_of[part];
    if (patch == none) {
      patch = static_cast<Index>(result.patches.size());
      result.patches.emplace_back();
      if (part != none) patch_of[part] = patch;
    }
    result.patches[patch].outline.loops.push_back(loop);
    for (const Index v : loop.points) {
      if (!alone(v, loop_of)) result.patches[patch].points.push_back(v < n ? v : outline.original[v - n]);
    }
  }
  for (Index i = 0; i < n; ++i) {
    if (loop_of[i] == shared) continue;
    const Index patch = patch_of[parts.find(i)];
    (patch == none ? result.left_out : result.patches[patch].points).push_back(i);
  }
  for (PatchInput& patch : result.patches) {
    std::sort(patch.points.begin(), patch.points.end());
    patch.points.erase(std::unique(patch.points.begin(), patch.points.end()), patch.points.end());
    const auto outer_first = [](const Loop& a, const Loop& b) {
      return a.kind == LoopKind::Outer && b.kind != LoopKind::Outer;
    };
    std::stable_sort(patch.outline.loops.begin(), patch.outline.loops.end(), outer_first);
    make_local(outline, n, patch);
  }
  return result;
}

Partition without_points(Partition parts, const std::vector<Index>& points) {
  for (PatchInput& patch : parts.patches) {
    std::vector<Index> number(patch.points.size(), none), kept;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
      if (std::binary_search(points.begin(), points.end(), patch.points[i])) continue;
      number[i] = static_cast<Index>(kept.size());
      kept.push_back(patch.points[i]);
    }
    const auto before = static_cast<Index>(patch.points.size());
    const Index gone = before - static_cast<Index>(kept.size());
    for (Loop& loop : patch.outline.loops) {
      for (Index& v : loop.points) v = v < before ? number[v] : v - gone;
    }
    for (Index& v : patch.outline.original) v = number[v];
    patch.points = std::move(kept);
  }
  parts.left_out.insert(parts.left_out.end(), points.begin(), points.end());
  std::sort(parts.left_out.begin(), parts.left_out.end());
  parts.left_out.erase(std::unique(parts.left_out.begin(), parts.left_out.end()), parts.left_out.end());
  return parts;
}

}  // namespace rimline
