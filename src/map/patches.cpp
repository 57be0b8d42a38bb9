// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/patches.h"

#include <algorithm>
#include <map>

#include "union_find.h"

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
  const std::span<const Index> star = stars.of(from);
  return std::find(star.begin(), star.end(), to) != star.end();
}

void join_mutual(const Stars& stars, const std::vector<Index>& loop_of, UnionFind& parts) {
  for (Index i = 0; i < static_cast<Index>(loop_of.size()); ++i) {
    if (loop_of[i] == shared) continue;
    for (const Index j : stars.of(i)) {
      if (j <= i || loop_of[j] == shared) continue;
      if (loop_of[i] != none && loop_of[j] != none) continue;  // cells at a rim reach over gaps
      if (names(stars, j, i)) parts.join(i, j);
    }
  }
}

std::vector<char> bounded_parts(const std::vector<Index>& loop_of, const std::vector<Loop>& loops,
                                UnionFind& parts) {
  const Index n = static_cast<Index>(loop_of.size());
  std::vector<char> bounded(n, 0);
  for (const Loop& loop : loops) {
    for (const Index v : loop.points) {
      if (v < n && loop_of[v] != shared) bounded[parts.find(v)] = 1;
    }
  }
  return bounded;
}

bool any_loose(const std::vector<Index>& loop_of, const std::vector<Loop>& loops, UnionFind& parts) {
  const std::vector<char> bounded = bounded_parts(loop_of, loops, parts);
  for (Index i = 0; i < static_cast<Index>(loop_of.size()); ++i) {
    if (loop_of[i] != shared && !bounded[parts.find(i)]) return true;
  }
  return false;
}

// Points that hang together with no loop but whose cells name, or are named by, points that do.
void join_one_sided(const Stars& stars, const std::vector<Index>& loop_of, const std::vector<Loop>& loops,
                    UnionFind& parts) {
  const Index n = static_cast<Index>(loop_of.size());
  for (bool again = true; again;) {
    again = false;
    std::vector<char> bounded = bounded_parts(loop_of, loops, parts);
    for (Index i = 0; i < n; ++i) {
      if (loop_of[i] == shared) continue;
      for (const Index j : stars.of(i)) {
        if (j == none || loop_of[j] == shared) continue;
        const Index a = parts.find(i), b = parts.find(j);
        if (bounded[a] == bounded[b]) continue;
        // A part as large as what it would join is a surface of its own.
        const Index loose = bounded[a] ? b : a, firm = bounded[a] ? a : b;
        if (2 * parts.size_of(loose) > parts.size_of(firm)) continue;
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

// Gives the loops' points ids of the patch: a point that they pass again gets a copy.
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
  if (any_loose(loop_of, outline.loops, parts)) join_one_sided(stars(), loop_of, outline.loops, parts);

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

}  // namespace rimline
