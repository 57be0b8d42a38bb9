// SPDX-License-Identifier: GPL-3.0-or-later
// refine_patch() with a first mesh, or with known stars.
#pragma once

#include <optional>
#include <vector>

#include "local/star.h"
#include "mesh/triangulation.h"
#include "rimline/refine_surface.h"

namespace rimline {

// `first`: a disc with holes over all points that ends at the loops; without it, it is made from a map.
// `stars` may be null: they are then found where needed.
Patch refine_patch(Points points, const Neighbours& neighbours, const Stars* stars,
                   const std::vector<Loop>& loops, std::optional<Triangulation> first,
                   const RefineOptions& options, const Run& run);

// Finishes a mesh of any other topology: its edges are flipped in space if it is orientable, its holes are
// filled; it gets no map. `loops` may be empty.
Patch finish_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   std::vector<Triangle> triangles, bool orientable, const RefineOptions& options,
                   const Run& run);

}  // namespace rimline
