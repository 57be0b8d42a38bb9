// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that the loops were found on, made a mesh: a start that is nearer to the surface than any
// triangulation of a first map.
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangulation.h"
#include "rimline/neighbours.h"

namespace rimline {

// A disc with holes over all points whose boundary edges are the loops, made of `triangles`: of fans that
// meet in a point alone the largest stays, gaps are closed, points that no triangle has are put into the
// nearest one. Nothing where that would take more than mending: the triangles do not end at the loops, have a
// handle, are one-sided, lack a hundredth of the points, or have a gap too large to close well.
std::optional<Triangulation> mesh_of_survey(Points points, const Neighbours& neighbours,
                                            const std::vector<Loop>& loops, std::vector<Triangle> triangles);

}  // namespace rimline
