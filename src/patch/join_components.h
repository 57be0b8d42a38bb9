// SPDX-License-Identifier: GPL-3.0-or-later
// Joins components that were meshed one by one into one surface.
#pragma once

#include <vector>

#include "patch/mesh_part.h"
#include "rimline/refine_surface.h"

namespace rimline {

// Joins the components, in their order, with ids of the whole's `points`; their maps are placed side by side.
// A map with flipped triangles is dropped.
Surface join_components(std::size_t points, std::vector<Component> components, const RefineOptions& options);

}  // namespace rimline
