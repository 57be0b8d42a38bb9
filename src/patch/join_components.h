// SPDX-License-Identifier: GPL-3.0-or-later
// Components that were meshed one by one, as one surface.
#pragma once

#include <vector>

#include "patch/mesh_part.h"
#include "rimline/refine_surface.h"

namespace rimline {

// Puts the components together, in their order, in ids of the whole's `points`; their maps side by side. A
// map that turns triangles over is none.
Surface join_components(std::size_t points, std::vector<Component> components, const RefineOptions& options);

}  // namespace rimline
