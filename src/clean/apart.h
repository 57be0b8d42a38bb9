// SPDX-License-Identifier: GPL-3.0-or-later
// Small groups of points that are separate from all others.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Marks (1) the points of connected groups, where two points are connected by a gap of at most three times
// the larger scale of both, that have at most 2 % of all points and at most 50; and single points that are
// 2.5 times as far from the nearest as the largest scale of the six next to it. Without `singles`: groups of a
// least size alone.
// `scale`: usual_spacing(); `left_out`: points (1) that connect nothing.
std::vector<char> lies_apart(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                             const std::vector<char>& left_out, bool singles, const Run& run);

}  // namespace rimline
