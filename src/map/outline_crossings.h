// SPDX-License-Identifier: GPL-3.0-or-later
// Finds self-crossings of the outline of a map.
#pragma once

#include <array>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// The points, ascending, of all edges of the loops that cross or touch an edge of the same or another loop
// with which they share no end.
std::vector<Index> crossing_points(const std::vector<Loop>& loops, const std::vector<UV>& uv);

}  // namespace rimline
