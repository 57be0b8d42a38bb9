// SPDX-License-Identifier: GPL-3.0-or-later
// Removes handles that are noise.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// Cuts handles (and one-sided strips) along closed curves of at most eight edges that bound no part of their
// component, then along bands that three edges or fewer cross, from a rim to the same rim. The triangles at
// the curve are removed and the gaps are closed, so that the number of rims stays the same. A repair removes
// at most a hundredth of the component's triangles, or, except for bands of three edges, two dozen where that
// is more. The work is bounded; remaining handles stay. Returns the repairs, with ids of the mesh. Throws
// Cancelled.
std::vector<HandleRepair> repair_handles(EditableMesh& mesh, const Run& run);

}  // namespace rimline
