// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the connected components of the selected triangles.
#pragma once

#include <vector>

#include "rimline/boundary_loops.h"
#include "surface/components.h"

namespace rimline {

// Whether a component is large enough to be a surface.
bool is_surface(const SurfaceComponent& component);

// Points, triangles and Euler number of each component; loops are not counted yet.
std::vector<SurfaceComponent> measure_components(const TriangleSet& set, const Selection& selection,
                                                 const Components& components, const Run& run);

// Interior where a point is in a triangle of a surface, else stray.
std::vector<PointLabel> label_stray_points(const TriangleSet& set, const Components& components,
                                           const std::vector<SurfaceComponent>& measured, const Run& run);

}  // namespace rimline
