// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulates a closed polygon in space without new vertices.
#pragma once

#include <functional>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// Whether two corners of the polygon, by their positions, may be joined by an edge.
using MayJoin = std::function<bool(Index, Index)>;

// n - 2 triangles over the polygon's n corners; each side of the polygon is in one of them, in its direction.
// Empty where `may_join` allows none. Least area (Barequet & Sharir 1995, dynamic programming, O(n^3)) up to
// 200 corners. A larger polygon is triangulated in the plane of its vector area if its projection does not
// cross itself. Otherwise it is divided: first the polygon of every m-th corner, then each of the polygons in
// between. [ours]
std::vector<Triangle> triangulate_polygon(Points corners, const MayJoin& may_join);

}  // namespace rimline
