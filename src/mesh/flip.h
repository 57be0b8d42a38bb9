// SPDX-License-Identifier: GPL-3.0-or-later
// Edge flips by the opposite-angle rule, in space.
#pragma once

#include <cstddef>
#include <functional>

#include "mesh/triangulation.h"
#include "rimline/run.h"

namespace rimline {

// Flips inner edges while the two opposite angles sum to more than pi, unless the new edge exists already, or
// would fold the surface: make two triangles face away from each other that did not. Boundary edges stay.
// `may_join` may be empty; else it refuses edges. Returns the number of flips. Deterministic.
std::size_t flip_edges(Points points, Triangulation& mesh, const Run& run,
                       const std::function<bool(Index, Index)>& may_join = {});

}  // namespace rimline
