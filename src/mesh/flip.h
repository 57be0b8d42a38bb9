// SPDX-License-Identifier: GPL-3.0-or-later
// Edge flips by the rule of the opposite angles, in space.
#pragma once

#include <cstddef>

#include "mesh/triangulation.h"
#include "rimline/run.h"

namespace rimline {

// Flips inner edges while the two angles opposite to one sum to more than pi, unless the new edge exists
// already. Boundary edges stay. Returns the number of flips. Deterministic.
std::size_t flip_edges(Points points, Triangulation& mesh, const Run& run);

}  // namespace rimline
