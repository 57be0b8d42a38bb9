// SPDX-License-Identifier: GPL-3.0-or-later
// Weighted graphs over points, and the convex combination map that they define.
#pragma once

#include <span>
#include <vector>

#include "local/star.h"
#include "rimline/mesh.h"
#include "rimline/report.h"
#include "solve/sparse.h"

namespace rimline {

// Both directions of each edge are stored, with the same positive weight; each row ascends by id.
struct Graph {
  std::vector<Index> offsets = {0};  // size() + 1
  std::vector<Index> neighbours;
  std::vector<double> weights;

  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
};

struct WeightedEdge {
  Index a, b;
  double weight;
};

// Weights of edges named twice, in either direction, are added.
Graph make_graph(Index size, const std::vector<WeightedEdge>& edges);

// The nodes that no path joins to a fixed one, ascending: for these eq. (4) is singular.
std::vector<Index> unreachable(const Graph& graph, const std::vector<char>& fixed);

// The rows of eq. (4) for the nodes that are not fixed, each times the sum of its weights: symmetric.
struct MapSystem {
  SymmetricMatrix matrix;
  std::vector<UV> right;
  std::vector<Index> unknown;  // the row of each node, or none where it is fixed
};

MapSystem graph_system(const Graph& graph, const std::vector<char>& fixed, const std::vector<UV>& uv);

// Solves a system whose rows all depend on the fixed nodes. `uv` holds the fixed positions and a first guess,
// of all nodes. The residual may end above `tolerance` where rounding leaves no more.
MapSummary solve_system(MapSystem system, double tolerance, std::vector<UV>& uv, const Run& run);

// Solves eq. (4) with the graph's weights: every node that is not fixed becomes the weighted mean of its
// neighbours. `uv` holds the fixed positions and a first guess. The residual may end above `tolerance` where
// rounding leaves no more. Throws UnreachableInterior, naming nodes, before any solve.
MapSummary solve_map(const Graph& graph, const std::vector<char>& fixed, double tolerance,
                     std::vector<UV>& uv, const Run& run);

}  // namespace rimline
