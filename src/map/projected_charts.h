// SPDX-License-Identifier: GPL-3.0-or-later
// Charts by projection, for clouds that are no surface.
#pragma once

#include <optional>
#include <vector>

#include "map/atlas.h"

namespace rimline {

// Whether handles are so many that the mesh follows no surface: more than one for a hundred vertices. No cuts
// lead to few charts then, and each would take a system to solve.
bool is_tangled(const OpenMesh& whole);

// Charts that are projections along the normal of their first triangle: triangles are added to it over their
// sides while their normals are within 75 degrees: no length shrinks to less than a quarter, so that the
// worst stretch is at most 4 and the mean at most 1.75, whatever mixture of slopes there is. Charts whose
// outline crosses itself are bisected. None where a single triangle has no map. Linear in the triangles but
// for the outlines.
std::optional<std::vector<Chart>> projected_charts(const OpenMesh& whole, const Run& run);

}  // namespace rimline
