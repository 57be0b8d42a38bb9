// SPDX-License-Identifier: GPL-3.0-or-later
// Empty space beyond a rim.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// The radius, in spacings, of the largest empty ball through both ends of a rim edge with its centre beyond
// the edge, in the plane of its triangle (with third corner `inner`); at most 5. Beyond a true boundary there
// is nothing; where the triangulation ends at a crease or a thin wall the surface continues.
double empty_ball_radius(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         Index a, Index b, Index inner);

}  // namespace rimline
