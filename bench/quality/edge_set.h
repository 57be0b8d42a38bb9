// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of edges without direction, kept sorted so that sets can be compared in one pass.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::bench {

struct Edge {
  Index a = 0, b = 0;  // a <= b

  static Edge of(Index p, Index q) { return p < q ? Edge{p, q} : Edge{q, p}; }
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

using EdgeSet = std::vector<Edge>;  // ascending, each once

// Sorts and drops repeated ones.
EdgeSet make_set(std::vector<Edge> edges);
EdgeSet edges_of_loop(std::span<const Index> loop);
std::size_t count_common(const EdgeSet& a, const EdgeSet& b);

// The edges of a mesh and how many triangles each has.
struct MeshEdges {
  EdgeSet edges;
  std::vector<int> triangles;
};
MeshEdges edges_of_mesh(const std::vector<Triangle>& mesh);
// Those with one triangle.
EdgeSet boundary_of(const MeshEdges& edges);

// The connected pieces of a set of edges, in the order of their least edge.
std::vector<EdgeSet> connected_pieces(const EdgeSet& edges);

}  // namespace rimline::bench
