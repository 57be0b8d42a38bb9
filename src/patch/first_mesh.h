// SPDX-License-Identifier: GPL-3.0-or-later
// A first mesh of a disc with holes over points without triangles: section 5, with our neighbourhoods.
#pragma once

#include <vector>

#include "local/star.h"
#include "mesh/triangulation.h"

namespace rimline {

// One entry per point and one per hole: the outer loop, the first, on the unit circle by chord length.
std::vector<UV> outline_on_circle(Points points, const std::vector<Loop>& loops);

// Delaunay triangulation of the map that the local Voronoi cells define as neighbourhoods (eq. (4)). `uv`
// must come from outline_on_circle(); it becomes the map. Throws NotADisc where rims cross in the plane and
// UnreachableInterior, naming points without a chain of neighbours to the outer loop.
Triangulation first_mesh(Points points, const Neighbours& neighbours, const Stars& stars,
                         const std::vector<Loop>& loops, std::vector<UV>& uv, const Run& run);

// Delaunay triangulation of uv inside the loops; points that coincide in uv are inserted in space. Throws as
// first_mesh() does.
Triangulation mesh_in_plane(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                            const std::vector<UV>& uv);

}  // namespace rimline
