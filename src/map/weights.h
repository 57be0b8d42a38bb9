// SPDX-License-Identifier: GPL-3.0-or-later
// The weights of the convex combination map: first among neighbours, then on a mesh.
#pragma once

#include <span>
#include <vector>

#include "local/star.h"
#include "map/graph.h"
#include "mesh/triangulation.h"

namespace rimline {

// The edges of the local Voronoi cells; each weight is the mean of both sides.
std::vector<WeightedEdge> star_edges(const Stars& stars);

// Distributes the edges of a point where loops touched: two wedges of the surface meet there, and a copy of
// the point (id point_count + i for original[i]) has one of them. Each edge goes to the copy whose edges of
// the loop are nearer.
void share_with_copies(Points points, const std::vector<Loop>& loops, const std::vector<Index>& original,
                       std::vector<WeightedEdge>& edges);

// Joins nodes without a path to a fixed node to those of their neighbours that have one, with small weights.
// Nodes without such neighbours stay apart.
void join_islands(const Neighbours& neighbours, const std::vector<char>& fixed,
                  std::vector<WeightedEdge>& edges);

// Closes each hole (all loops but the first) for the solve by an additional node, joined to the rim like the
// centre of a regular polygon to its corners. These nodes follow the points.
void add_wheels(const std::vector<Loop>& loops, Index point_count, std::vector<WeightedEdge>& edges);

// Half the cotangents of the angles opposite to the edge at corner c of triangle t, in space: a discrete
// harmonic map (Pinkall & Polthier 1993). The same to the last bit from both sides of the edge. Kept within
// [least, most], as an embedding needs positive weights (Tutte 1963; Floater 1997) and double precision wants
// them within a few decades of each other. Where `evenness` is given (one value of 0 to 1 per point), weights
// are drawn towards 1 by the larger value of the edge's ends.
double cotangent_weight(Points points, const Triangulation& mesh, Index t, int c,
                        std::span<const double> evenness);

}  // namespace rimline
