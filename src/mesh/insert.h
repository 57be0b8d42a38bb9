// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts points that a triangulation of the plane left out, in space.
#pragma once

#include "mesh/triangulation.h"
#include "rimline/neighbours.h"

namespace rimline {

// For each vertex without a triangle, splits the triangle with the nearest centre among those at its nearest
// neighbours. Vertices whose neighbours have no triangle yet wait for them. Returns the vertices that remain
// without, ascending.
std::vector<Index> insert_missing(Points points, const Neighbours& neighbours, Triangulation& mesh);

}  // namespace rimline
