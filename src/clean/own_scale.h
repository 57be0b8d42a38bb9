// SPDX-License-Identifier: GPL-3.0-or-later
// A second look at a point that seems far from its neighbours: as coarse as its own distance to the nearest.
// Where the density changes, a point of the coarse side has nothing but points of the fine side among its
// nearest.
#pragma once

#include "points/kd_tree.h"
#include "rimline/points.h"

namespace rimline {

// Whether a point lies on the surface that the points around it make when they are thinned to about the
// distance of the nearest, and is no end of it: they surround it, or some are as far from others as it is.
// `nearest`: that distance, above 0.
bool fits_at_own_scale(const KdTree& tree, Points points, const std::vector<double>& spacing, Index self,
                       double nearest);

}  // namespace rimline
