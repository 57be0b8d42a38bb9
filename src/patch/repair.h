// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs the triangles that the loops were found on, as a first mesh: it is nearer to the surface than any
// triangulation of a first map.
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangulation.h"
#include "rimline/neighbours.h"

namespace rimline {

// Returns a disc with holes over all points whose boundary edges are the loops, made of `triangles`: where
// fans touch in a point the largest stays, gaps are closed, and points in no triangle are inserted in the
// nearest one. None where that is not enough: the triangles do not end at the loops, have a handle, are one-
// sided, lack a hundredth of the points, or have a gap too large to close well.
std::optional<Triangulation> mesh_of_survey(Points points, const Neighbours& neighbours,
                                            const std::vector<Loop>& loops, std::vector<Triangle> triangles);

}  // namespace rimline
