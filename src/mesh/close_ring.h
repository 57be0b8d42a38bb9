// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulates a gap of a mesh.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Triangulates the closed polygon of points, in its direction, with the least area in space (Barequet &
// Sharir 1995), ties by short edges. `taken(a, b)` tells the edges that must not be made. Empty where there
// is no triangulation. The time grows with the third power of the polygon's size.
std::vector<Triangle> close_ring(Points points, std::span<const Index> ring,
                                 const std::function<bool(Index, Index)>& taken);

}  // namespace rimline
