// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay triangulation of parameter points inside given loops.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangulation.h"
#include "rimline/run.h"

namespace rimline {

// Triangles inside the first loop and outside the others, counter-clockwise in uv, with every edge of the
// loops. Points that coincide with another one in uv (never two of the loops'), and points inside a hole, are
// in no triangle. Exact predicates. Throws NotADisc, naming points of the loops, where loops cross or touch
// one another in uv.
std::vector<Triangle> constrained_delaunay(std::span<const UV> uv, const std::vector<Loop>& loops);

}  // namespace rimline
