// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "measure/triangle_tree.h"
#include "measure/triangles_meet.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

using Pair = std::array<Index, 2>;

// Whether a plane separates the two triangles by more than rounding, except at vertices that they share: true
// for nearly all neighbours, and cheap. The margin covers the rounding of the products.
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

// Pairs of the triangles of `group`, a node, with those after them in the tree's order. Goes down on both
// sides at once, into the larger one first.
void search_group(Points points, const std::vector<Triangle>& triangles, const TriangleTree& tree,
                  Index group, std::size_t most, std::vector<Pair>& found) {
  const auto& nodes = tree.nodes();
  const auto compare = [&](Index i, Index j) {
    const Index s = tree.order()[i], t = tree.order()[j];
    if (!tree.box(s).meets(tree.box(t)) || plainly_apart(points, triangles[s], triangles[t])) return;
    if (triangles_meet(points, triangles[s], triangles[t])) found.push_back({std::min(s, t), std::max(s, t)});
  };
  std::vector<Index> within;
  std::vector<Pair> open = {{group, 0}};
  while (!open.empty() && found.size() < most) {
    const auto [a, b] = open.back();
    open.pop_back();
    const TriangleTree::Node &own = nodes[a], &other = nodes[b];
    if (other.end <= own.begin || !own.box.meets(other.box)) continue;
    if (own.is_leaf() && other.is_leaf()) {
      within.clear();  // few triangles of two leaves side by side reach into both
      for (Index j = other.begin; j < other.end; ++j) {
        if (own.box.meets(tree.box(tree.order()[j]))) within.push_back(j);
      }
      for (Index i = own.begin; i < own.end; ++i) {
        if (!other.box.meets(tree.box(tree.order()[i]))) continue;
        for (const Index j : within) {
          if (j > i) compare(i, j);
        }
      }
    } else if (own.is_leaf() || (!other.is_leaf() && other.end - other.begin >= own.end - own.begin)) {
      open.push_back({a, other.left});
      open.push_back({a, other.right});
    } else {
      open.push_back({own.left, b});
      open.push_back({own.right, b});
    }
  }
}

}  // namespace

std::vector<Pair> find_self_intersections(Points points, const std::vector<Triangle>& triangles,
                                          const Run& run, std::size_t most) {
  const TriangleTree tree(points, triangles, run);
  // The nodes that hold as many triangles as one search starts from.
  constexpr Index group_size = 256;
  std::vector<Index> groups;
  std::vector<Index> open;
  if (!tree.nodes().empty()) open.push_back(0);
  while (!open.empty()) {
    const Index n = open.back();
    open.pop_back();
    const TriangleTree::Node& node = tree.nodes()[n];
    if (node.is_leaf() || node.end - node.begin <= group_size) {
      groups.push_back(n);
    } else {
      open.insert(open.end(), {node.left, node.right});
    }
  }
  constexpr std::size_t batch = 512;  // groups between two looks at how many there are
  std::vector<Pair> pairs;
  for (std::size_t first = 0; first < groups.size() && pairs.size() < most; first += batch) {
    std::vector<std::vector<Pair>> found(std::min(batch, groups.size() - first));
    const auto search = [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
        search_group(points, triangles, tree, groups[first + g], most, found[g]);
    };
    parallel_slices(found.size(), Stage::Measure, run, search, 4);
    for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  }
  if (pairs.size() > most) pairs.resize(most);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace rimline
