// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that are noise.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// Cuts handles (and one-sided strips) along closed curves of at most eight edges that bound no part of their
// component, then bands that three edges or fewer lead across, from a rim to the same rim: triangles at the
// curve go, and what opens is closed, so that as many rims are left as there were. A repair takes out no more
// than a hundredth of the component's triangles, or, but for bands of three edges, two dozen where that is
// more. Work is bounded; what is left over stays a handle. Returns what was done, with ids of the mesh.
// Throws Cancelled.
std::vector<HandleRepair> repair_handles(EditableMesh& mesh, const Run& run);

}  // namespace rimline
