// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/short_cycle.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/union_find.h"
#include "mesh/triangulation.h"

namespace rimline {
namespace {

// Steps from the nearest root, and the vertex before; -1 and none where it is not reached.
struct Tree {
  std::vector<Index> reached;  // by distance
  std::vector<int> distance;
  std::vector<Index> parent;
};

Tree grow(const EditableMesh& mesh, std::vector<Index> roots) {
  const auto vertices = static_cast<std::size_t>(mesh.vertices());
  Tree tree{std::move(roots), std::vector<int>(vertices, -1), std::vector<Index>(vertices, none)};
  for (const Index root : tree.reached) tree.distance[root] = 0;
  for (std::size_t i = 0; i < tree.reached.size(); ++i) {
    const Index v = tree.reached[i];
    for (const Index t : mesh.star(v)) {
      for (const Index w : mesh.triangle(t)) {
        if (tree.distance[w] >= 0) continue;
        tree.distance[w] = tree.distance[v] + 1;
        tree.parent[w] = v;
        tree.reached.push_back(w);
      }
    }
  }
  return tree;
}

// An edge that is not in the tree, with the faces on both sides: triangles, then caps of rims.
struct Crossing {
  Index a, b;
  int length;  // of the curve root - a - b - root
  Index left, right;
};

// Open edges of the rim `passed` are left out.
std::vector<Crossing> crossings_of(const Capped& surface, const Tree& tree, Index passed = none) {
  const EditableMesh& mesh = surface.mesh;
  std::vector<Crossing> crossings;
  for (const Index v : tree.reached) {
    for (const Index t : mesh.star(v)) {
      for (const Index w : mesh.triangle(t)) {
        if (w == v || tree.parent[v] == w || tree.parent[w] == v) continue;
        const Index other = mesh.across(t, v, w);
        // Each edge once: from its lower end and its lower triangle.
        if (w < v || (other != none && other < t) || (other == none && surface.rim_of[v] == passed)) continue;
        const Index beyond = other != none ? other : mesh.places() + surface.rim_of[v];
        crossings.push_back({v, w, tree.distance[v] + tree.distance[w] + 1, t, beyond});
      }
    }
  }
  std::ranges::stable_sort(crossings, [](const Crossing& x, const Crossing& y) {
    return std::tuple(-x.length, x.a, x.b) < std::tuple(-y.length, y.a, y.b);
  });
  return crossings;
}

// The closed curve without the path from the root that its two halves share.
std::vector<Index> curve_of(const Tree& tree, const Crossing& crossing) {
  std::vector<Index> to_a{crossing.a}, to_b{crossing.b};
  while (to_a.back() != to_b.back()) {
    std::vector<Index>& longer = tree.distance[to_a.back()] >= tree.distance[to_b.back()] ? to_a : to_b;
    longer.push_back(tree.parent[longer.back()]);
  }
  to_b.pop_back();
  to_a.insert(to_a.end(), to_b.rbegin(), to_b.rend());
  return to_a;
}

// From the vertex back to its root.
std::vector<Index> way_back(const Tree& tree, Index vertex) {
  std::vector<Index> way;
  for (Index v = vertex; v != none; v = tree.parent[v]) way.push_back(v);
  return way;
}

// The edges that remain when faces are joined across the longest curves first: the shortest curves that bound
// nothing, the shortest last.
std::vector<Crossing> left_over(const Capped& surface, const std::vector<Crossing>& crossings) {
  const Index rims = 1 + *std::ranges::max_element(surface.rim_of);
  UnionFind faces(static_cast<std::size_t>(surface.mesh.places() + rims));
  std::vector<Crossing> left;
  for (const Crossing& crossing : crossings) {
    if (!faces.join(crossing.left, crossing.right)) left.push_back(crossing);
  }
  return left;
}

}  // namespace

CyclesAt cycles_at(const Capped& surface, Index vertex) {
  const Tree tree = grow(surface.mesh, {vertex});
  const std::vector<Crossing> left = left_over(surface, crossings_of(surface, tree));
  CyclesAt cycles;
  if (left.empty()) return cycles;
  cycles.shortest = curve_of(tree, left.back());
  for (std::size_t i = 0; i + 1 < left.size(); ++i) cycles.others.push_back(left[i].a);
  return cycles;
}

std::vector<std::vector<Index>> arcs_at(const Capped& surface, const std::vector<Index>& ends) {
  const Tree tree = grow(surface.mesh, ends);
  const Index passed = surface.rim_of[ends.front()];
  std::vector<Crossing> left = left_over(surface, crossings_of(surface, tree, passed));
  std::ranges::reverse(left);
  std::vector<std::vector<Index>> arcs;
  for (const Crossing& crossing : left) {
    std::vector<Index> arc = way_back(tree, crossing.a), back = way_back(tree, crossing.b);
    if (arc.back() == back.back()) continue;
    std::ranges::reverse(arc);
    arc.insert(arc.end(), back.begin(), back.end());
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

}  // namespace rimline
