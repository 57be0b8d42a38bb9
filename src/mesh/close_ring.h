// SPDX-License-Identifier: GPL-3.0-or-later
// A gap of a mesh, closed.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Triangulates the ring of points, in its direction, with the least area in space (Barequet & Sharir 1995),
// among equal ones with short edges. `taken(a, b)` tells the edges that may not be made. Empty where there is
// no way. Takes time with the third power of the ring's size.
std::vector<Triangle> close_ring(Points points, std::span<const Index> ring,
                                 const std::function<bool(Index, Index)>& taken);

}  // namespace rimline
