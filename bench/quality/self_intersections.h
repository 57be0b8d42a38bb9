// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::bench {

// Pairs of triangles that meet in more than the vertex or edge they share, with exact predicates. Triangles
// of no area take no part.
std::size_t count_self_intersections(Points points, const std::vector<Triangle>& mesh);

}  // namespace rimline::bench
