// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/short_cycle.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/union_find.h"
#include "mesh/triangulation.h"

namespace rimline {
namespace {

// Steps from the root, and the vertex before; -1 and none where it does not come.
struct Tree {
  std::vector<Index> reached;  // by distance
  std::vector<int> distance;
  std::vector<Index> parent;
};

Tree grow(const EditableMesh& mesh, Index root) {
  const auto vertices = static_cast<std::size_t>(mesh.vertices());
  Tree tree{{root}, std::vector<int>(vertices, -1), std::vector<Index>(vertices, none)};
  tree.distance[root] = 0;
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
  int length;  // of the closed curve root - a - b - root
  Index left, right;
};

std::vector<Crossing> crossings_of(const Capped& surface, const Tree& tree) {
  const EditableMesh& mesh = surface.mesh;
  std::vector<Crossing> crossings;
  for (const Index v : tree.reached) {
    for (const Index t : mesh.star(v)) {
      for (const Index w : mesh.triangle(t)) {
        if (w == v || tree.parent[v] == w || tree.parent[w] == v) continue;
        const Index other = mesh.across(t, v, w);
        // Each edge once: from its lower end and its lower triangle.
        if (w < v || (other != none && other < t)) continue;
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

// The closed curve without the way from the root that its two halves share.
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

}  // namespace

CyclesAt cycles_at(const Capped& surface, Index vertex) {
  const Tree tree = grow(surface.mesh, vertex);
  const Index rims = 1 + *std::ranges::max_element(surface.rim_of);
  UnionFind faces(static_cast<std::size_t>(surface.mesh.places() + rims));
  // Faces are joined over the longest curves first; those left over are the shortest that bound nothing.
  CyclesAt cycles;
  for (const Crossing& crossing : crossings_of(surface, tree)) {
    if (faces.join(crossing.left, crossing.right)) continue;
    cycles.shortest = curve_of(tree, crossing);
    cycles.others.push_back(crossing.a);
  }
  if (!cycles.others.empty()) cycles.others.pop_back();
  return cycles;
}

}  // namespace rimline
