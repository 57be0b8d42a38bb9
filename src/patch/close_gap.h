// SPDX-License-Identifier: GPL-3.0-or-later
// Closes a rim that is not a boundary.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// Closes a rim, given as walk_rims() returns it, with the least area. Returns false, and leaves the mesh
// unchanged, where every triangulation would repeat an edge of the mesh, and for rims of more than 200
// points, which would take too long.
bool close_gap(EditableMesh& mesh, const std::vector<Index>& rim);

}  // namespace rimline
