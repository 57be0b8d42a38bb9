// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "measure/triangle_tree.h"
#include "measure/triangles_meet.h"
#include "parallel.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

using Pair = std::array<Index, 2>;

// Whether a plane plainly parts the two triangles, but for vertices that they share: true for nearly all
// neighbours, and cheap. The margin covers the rounding of the products.
bool plainly_apart(Points points, const Triangle& s, const Triangle& t) {
  constexpr double margin = 1e-14;  // of the cosine: far above what rounding does
  Index shared = none;
  int common = 0;
  for (const Index v : s) {
    if (v == t[0] || v == t[1] || v == t[2]) {
      shared = v;
      ++common;
    }
  }
  if (common > 2) return false;
  const auto centre = [&](const Triangle& x) {
    return (1.0 / 3) * (points[x[0]] + points[x[1]] + points[x[2]]);
  };
  Point across = centre(t) - centre(s);
  Point foot = common == 0 ? 0.5 * (centre(t) + centre(s)) : points[shared];
  if (common == 2) {  // the plane through the shared edge
    Index other = none;
    for (const Index v : s) {
      if (v != shared && (v == t[0] || v == t[1] || v == t[2])) other = v;
    }
    const Point edge = points[other] - points[shared];
    const double length = dot(edge, edge);
    if (length == 0) return false;
    across = across - (dot(across, edge) / length) * edge;
  }
  const auto beyond = [&](Index v, double side) {
    const Point q = points[v] - foot;
    const double d = side * dot(q, across);
    return d > 0 && d * d > margin * margin * dot(q, q) * dot(across, across);
  };
  const auto is_shared = [&](Index v, const Triangle& x) { return v == x[0] || v == x[1] || v == x[2]; };
  for (const Index v : s) {
    if (!is_shared(v, t) && !beyond(v, -1)) return false;
  }
  for (const Index v : t) {
    if (!is_shared(v, s) && !beyond(v, 1)) return false;
  }
  return true;
}

// Pairs of a leaf's triangles with those after it in the tree's order.
void search_leaf(Points points, const std::vector<Triangle>& triangles, const TriangleTree& tree, Index leaf,
                 std::vector<Pair>& found) {
  const auto& nodes = tree.nodes();
  const auto& own = nodes[leaf];
  const auto compare = [&](Index i, Index j) {
    const Index s = tree.order()[i], t = tree.order()[j];
    if (!tree.box(s).meets(tree.box(t)) || plainly_apart(points, triangles[s], triangles[t])) return;
    if (triangles_meet(points, triangles[s], triangles[t])) found.push_back({std::min(s, t), std::max(s, t)});
  };
  std::vector<Index> open = {0};
  while (!open.empty()) {
    const TriangleTree::Node& node = nodes[open.back()];
    open.pop_back();
    if (node.end <= own.begin || !node.box.meets(own.box)) continue;
    if (!node.is_leaf()) {
      open.push_back(node.left);
      open.push_back(node.right);
      continue;
    }
    for (Index i = own.begin; i < own.end; ++i) {
      for (Index j = std::max(node.begin, i + 1); j < node.end; ++j) compare(i, j);
    }
  }
}

}  // namespace

std::vector<Pair> find_self_intersections(Points points, const std::vector<Triangle>& triangles,
                                          const Run& run) {
  const TriangleTree tree(points, triangles);
  std::vector<Index> leaves;
  for (Index n = 0; n < static_cast<Index>(tree.nodes().size()); ++n) {
    if (tree.nodes()[n].is_leaf()) leaves.push_back(n);
  }
  // Slices of leaves, so that each has a list of its own and most are never filled.
  constexpr std::size_t slice = 256;
  std::vector<std::vector<Pair>> found((leaves.size() + slice - 1) / slice);
  const auto search = [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part) {
      const std::size_t end = std::min(leaves.size(), (part + 1) * slice);
      for (std::size_t i = part * slice; i < end; ++i)
        search_leaf(points, triangles, tree, leaves[i], found[part]);
    }
  };
  parallel_slices(found.size(), Stage::Measure, run, search, 1);
  std::vector<Pair> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace rimline
