// SPDX-License-Identifier: GPL-3.0-or-later
// refine_patch() for those who have a first mesh, or know the points' cells already.
#pragma once

#include <optional>
#include <vector>

#include "local/star.h"
#include "mesh/triangulation.h"
#include "rimline/refine_surface.h"

namespace rimline {

// `first`: a disc with holes over all points that ends at the loops; where there is none, it is made of a
// map. `stars` may be null: they are found where they are needed.
Patch refine_patch(Points points, const Neighbours& neighbours, const Stars* stars,
                   const std::vector<Loop>& loops, std::optional<Triangulation> first,
                   const RefineOptions& options, const Run& run);

// A mesh of any other topology: its edges are flipped in space where it can be oriented, its holes filled; it
// gets no map. `loops` may be empty.
Patch finish_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   std::vector<Triangle> triangles, bool orientable, const RefineOptions& options,
                   const Run& run);

}  // namespace rimline
