// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "quality/metrics.h"
#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::bench {

// uv_flipped_triangles: those with no area or turned against most others of their component, and those
// without finite uv. uv_mean_angle_error_rad: mean absolute difference of a corner's angle in space and in
// uv.
Metrics score_uv(Points points, const std::vector<Triangle>& mesh, std::span<const UV> uv);

// The three angles of a triangle in space or (z = 0) in the plane, by atan2: exact for slivers too.
std::array<double, 3> angles_of(Point a, Point b, Point c);

}  // namespace rimline::bench
