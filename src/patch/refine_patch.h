// SPDX-License-Identifier: GPL-3.0-or-later
// refine_patch() for those who know the points' cells already.
#pragma once

#include <vector>

#include "local/voronoi_stars.h"
#include "patch/pinches.h"
#include "rimline/refine_surface.h"

namespace rimline {

// `outline` has ids of the points and, beyond them, of copies where it touches itself. `stars` may be null:
// they are found where they are needed. `survey` may be empty: triangles of the patch that the loops were
// found on, which serve as the first mesh where they can.
Patch refine_patch(Points points, const Neighbours& neighbours, const Stars* stars, const Separated& outline,
                   std::vector<Triangle> survey, const RefineOptions& options, const Run& run);

}  // namespace rimline
