// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a point its neighbours lie.
#pragma once

#include "local/samples.h"

namespace rimline {

// The direction of a vector along the tangent plane with this unit normal; 0 where it has none.
Point tangent_direction(const Point& vector, const Point& normal);

// The mean of the unit vectors from a point to its nearest neighbours, `count` of them or all that are known,
// along the tangent plane there. Its length is Rayleigh's statistic of uniform directions (Mardia and Jupp,
// Directional Statistics, 2000): 0 where neighbours are all around, 2 / pi in the middle of a straight
// boundary.
Point mean_direction(const Samples& samples, Index point, int count);

}  // namespace rimline
