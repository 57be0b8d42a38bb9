// SPDX-License-Identifier: GPL-3.0-or-later
// The conformal map whose outline is free.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/report.h"

namespace rimline {

// Least squares conformal map (Levy, Petitjean, Ray, Maillot 2002; as Dirichlet energy less area: Desbrun,
// Meyer, Alliez 2002) of a mesh with any number of boundary loops, scaled to the mesh's area and turned so
// that the outer loop's farthest points lie level. `uv` has one entry per vertex. Throws NoConvergence where
// the factorization fails.
MapSummary free_map(Points points, const Triangulation& mesh, const std::vector<Index>& outer_loop,
                    std::vector<UV>& uv, const Run& run);

// Closes each hole (all loops but the first) by triangles to a new point at the centre of its rim.
void add_caps(const std::vector<Loop>& loops, std::vector<Point>& points, Triangulation& mesh);

// Scales uv so that the triangles cover the area that they have in space.
void scale_to_area(Points points, const Triangulation& mesh, std::vector<UV>& uv);

// Moves vertices about flipped triangles to the means of their neighbours until none is flipped; those on
// the boundary stay. Returns how many triangles are flipped still.
std::size_t unflip(const Triangulation& mesh, std::vector<UV>& uv, const Run& run);

// Pairs of edges of the closed polygon that cross or touch.
std::size_t count_crossings(const std::vector<Index>& loop, const std::vector<UV>& uv);

}  // namespace rimline
