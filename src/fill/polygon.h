// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles over a closed polygon in space, without vertices of their own.
#pragma once

#include <functional>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// Whether two corners of the polygon, by their positions, may be joined by an edge.
using MayJoin = std::function<bool(Index, Index)>;

// n - 2 triangles over the polygon's n corners, each of its edges in one of them in its own direction; empty
// where `may_join` allows none. Of least area (Barequet & Sharir 1995, by dynamic programming, O(n^3)) up to
// 200 corners. A larger polygon is triangulated in the plane of its vector area if it does not cross itself
// there. Else it is divided: first every m-th corner, then each of the polygons in between. [ours]
std::vector<Triangle> triangulate_polygon(Points corners, const MayJoin& may_join);

}  // namespace rimline
