// SPDX-License-Identifier: GPL-3.0-or-later
// Costs of cuts, and shortest paths by these costs.
#pragma once

#include <vector>

#include "map/graph.h"
#include "map/open_mesh.h"

namespace rimline {

// The cost of a cut along a side: its length, more on ridges, which are visible, and less in valleys. In the
// unit of the points. The same from both sides.
double seam_cost(const OpenMesh& open, Index triangle, int corner);

// The edges of the mesh with these costs.
Graph seam_graph(const OpenMesh& open);

struct SeamPaths {
  std::vector<double> cost;  // of the path from each vertex to the source; infinite where there is none
  std::vector<Index> via;    // the next vertex on it, or none
};

// Dijkstra's shortest paths. Of equal ones the one over lower vertices.
SeamPaths paths_to(const Graph& graph, Index source);

// The vertex that is farthest from the source; of equal ones the lowest.
Index farthest(const SeamPaths& paths);

}  // namespace rimline
