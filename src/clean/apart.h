// SPDX-License-Identifier: GPL-3.0-or-later
// Small groups of points apart from all others.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// The points, 1 where true, of groups that hang together by gaps of at most three times the larger scale of
// both ends, and have at most 2 % of all points and at most 50; and single points that are 2.5 times as far
// from the nearest as the largest scale of the six next to it. `scale`: usual_spacing(); `left_out`, 1 where
// true: points that join nothing.
std::vector<char> lies_apart(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                             const std::vector<char>& left_out);

}  // namespace rimline
