// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles over a rim that is no boundary.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// Closes a rim, given as walk_rims() does, with the least area. False, and the mesh as it was, where every
// way would make an edge that the mesh has, and for rims of more than 200 points, which take too long.
bool close_gap(EditableMesh& mesh, const std::vector<Index>& rim);

}  // namespace rimline
