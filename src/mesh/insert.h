// SPDX-License-Identifier: GPL-3.0-or-later
// Points that a triangulation of the plane left out, put back in space.
#pragma once

#include "mesh/triangulation.h"
#include "rimline/neighbours.h"

namespace rimline {

// Splits, for each vertex that no triangle has, the triangle with the nearest centre among those at its
// nearest neighbours that have one. Vertices without such a neighbour wait for those that have. Returns the
// vertices that remained without, ascending.
std::vector<Index> insert_missing(Points points, const Neighbours& neighbours, Triangulation& mesh);

}  // namespace rimline
