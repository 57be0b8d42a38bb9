// SPDX-License-Identifier: GPL-3.0-or-later
// The conformal map with a free outline.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/report.h"

namespace rimline {

// Least squares conformal map (Levy, Petitjean, Ray, Maillot 2002; as Dirichlet energy less area: Desbrun,
// Meyer, Alliez 2002) of a mesh with any number of boundary loops. Weights of inner edges are at least
// `least` >= 0: each inner point is a convex combination of its neighbours, and hardly any triangle turns
// over. None is below zero where the opposite-angle rule holds, so that with 0 the map is then the exact one.
// The outline may cross itself, and holes may turn inside out. `uv` gets one entry per point; its scale is
// arbitrary. Throws NoConvergence where the factorization fails.
MapSummary free_map(Points points, const Triangulation& mesh, const std::vector<Index>& outer_loop,
                    double least, std::vector<UV>& uv, const Run& run);

// Rotates uv so that the farthest points of the outer loop are level.
void lay_level(Points points, const std::vector<Index>& outer_loop, std::vector<UV>& uv);

// Scales uv so that the triangles cover the area that they have in space.
void scale_to_area(Points points, const Triangulation& mesh, std::vector<UV>& uv);

}  // namespace rimline
