// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that are noise.
#pragma once

#include <span>
#include <vector>

#include "mesh/editable_mesh.h"
#include "rimline/report.h"

namespace rimline {

// Cuts handles (and one-sided strips) along closed curves of at most eight edges that bound no part of their
// component, and closes what opens: the triangles on one side of the curve go, the curve and the ring that
// they leave are filled. Nothing is changed at a rim, and a repair takes out no more than a hundredth of the
// component's triangles, or two dozen where that is more. `rims` are those of the mesh. No vertex is lost
// where the curve has two sides. Returns what was done, with ids of the mesh; its vertices tell the
// component.
std::vector<HandleRepair> repair_handles(EditableMesh& mesh, const std::vector<std::vector<Index>>& rims);

}  // namespace rimline
