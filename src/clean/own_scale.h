// SPDX-License-Identifier: GPL-3.0-or-later
// A second test of a point that seems far from its neighbours, at the scale of its distance to the nearest.
// Where the density changes, a point of the coarse side has only points of the fine side among its nearest.
#pragma once

#include "points/kd_tree.h"
#include "rimline/points.h"

namespace rimline {

// Whether a point lies on the surface of the points around it, thinned to about the distance of the nearest,
// and is not isolated there: they surround it, or some are as far from others as it is. `nearest`: that
// distance, above 0.
bool fits_at_own_scale(const KdTree& tree, Points points, const std::vector<double>& spacing, Index self,
                       double nearest);

}  // namespace rimline
