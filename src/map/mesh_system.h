// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (4) on a mesh with holes, assembled without a graph.
#pragma once

#include <span>
#include <vector>

#include "map/graph.h"
#include "mesh/triangulation.h"

namespace rimline {

// The system with cotangent_weight() on the edges of the mesh and with add_wheels(): that of graph_system(),
// to the last bit. `fixed` and `uv` have an entry per point and one per hole, as in embed().
MapSystem mesh_system(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                      std::span<const double> evenness, const std::vector<char>& fixed,
                      const std::vector<UV>& uv, const Run& run);

}  // namespace rimline
