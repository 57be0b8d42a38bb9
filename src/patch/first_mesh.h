// SPDX-License-Identifier: GPL-3.0-or-later
// A disc with holes over points of which no triangles are known: section 5, with our neighbourhoods.
#pragma once

#include <vector>

#include "local/star.h"
#include "mesh/triangulation.h"

namespace rimline {

// One entry per point and one per hole: the outer loop, the first, on the unit circle by chord length.
std::vector<UV> outline_on_circle(Points points, const std::vector<Loop>& loops);

// Delaunay triangulation of the map that the local Voronoi cells define as neighbourhoods (eq. (4)). `uv`
// as outline_on_circle() gives it; gets the map. Throws NotADisc where rims cross in the plane and
// UnreachableInterior, naming points that have no chain of neighbours to the outer loop.
Triangulation first_mesh(Points points, const Neighbours& neighbours, const Stars& stars,
                         const std::vector<Loop>& loops, std::vector<UV>& uv, const Run& run);

// Delaunay triangulation of uv within the loops; points that fall on others are put back in space. Throws as
// first_mesh() does.
Triangulation mesh_in_plane(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                            const std::vector<UV>& uv);

}  // namespace rimline
