// SPDX-License-Identifier: GPL-3.0-or-later
// A conformal map in nearly linear time: first the outline, then the inside.
#pragma once

#include <vector>

#include "map/open_mesh.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// The outline has the lengths of the longest loop and turns as `turning` says, one angle a vertex in its
// order (conformal_log_scale()); lengths are changed as little as closes it (Sawhney & Crane 2017). Inside,
// every vertex is the mean of its neighbours, with cotangent weights, and holes are closed by wheels.
// Triangles may turn over, and the outline may cross itself: the caller looks. `uv`: one per vertex.
MapSummary map_outline_first(const OpenMesh& open, const std::vector<double>& turning, double residual,
                             std::vector<UV>& uv, const Run& run);

// The closed polygon of these lengths and outer angles, counter-clockwise from (0, 0) along the axis u.
std::vector<UV> closed_outline(const std::vector<double>& lengths, const std::vector<double>& turning);

}  // namespace rimline
