// SPDX-License-Identifier: GPL-3.0-or-later
// Whether there is nothing beyond a rim.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline::exact {

// The radius, in spacings, of the largest empty ball through both ends of a rim edge whose centre lies beyond
// the edge: the least over directions that leave the edge within 60 degrees of the plane of its triangle
// (with third corner `inner`). At most 5. Beyond a true boundary there is nothing in any of them; beyond the
// end of what could be triangulated at a crease or a thin wall, the surface goes on at an angle.
double emptiness_beyond(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                        Index a, Index b, Index inner);

}  // namespace rimline::exact
