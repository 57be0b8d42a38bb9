// SPDX-License-Identifier: GPL-3.0-or-later
// The neighbour graph of a set of points (the band of a chromosome).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/score_boundary.h"

namespace rimline {

struct Join {
  Index a, b;  // positions in the set, a < b
  double length, cost;
};

// The points of a set by their index in it; two are joined where one is among the other's neighbours.
struct Band {
  std::vector<Join> joins;
  std::vector<std::vector<Index>> joins_of;  // positions in `joins`, for each point

  // The end of join `j` that is not `at`.
  Index other_end(Index j, Index at) const { return joins[j].a == at ? joins[j].b : joins[j].a; }
};

// Of the points `ids` (ascending), with `path_k` neighbours each. A join costs the cube of its length
// over the sum of both scores: many short steps along high scores beat few long ones.
Band make_band(Points points, const Neighbours& neighbours, int path_k, const BoundaryScores& scores,
               std::span<const Index> ids);

// The cheapest paths from a root to all points connected to it, for each part of the band.
struct Forest {
  std::vector<Index> parent;         // `none` for a root
  std::vector<Index> depth;          // points between it and its root
  std::vector<double> length, cost;  // of the way from the root
  std::vector<Index> order;          // every point, after its parent
};

// `by_rank` names all points of the band; the first one of each part is its root.
Forest cheapest_ways(const Band& band, std::span<const Index> by_rank);

// For each join, whether the cycle that it closes with the forest is essential: no sum of triangles of joins.
// In the terms of topology, its class in the first homology over GF(2) of the clique complex of the band is
// not zero. In a ring of points these cycles go around the ring; cycles within a patch, or within a piece of
// a broken ring, are not essential.
std::vector<std::uint8_t> going_round(const Band& band, const Forest& forest);

}  // namespace rimline
