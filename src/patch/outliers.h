// SPDX-License-Identifier: GPL-3.0-or-later
// Outliers: points that no mesh that ends at the loops can contain without overlapping itself.
#pragma once

#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"

namespace rimline {

// Points, ascending, in no triangle and on no loop, whose nearest position on the triangles of their
// neighbours lies on an edge of a loop, or whose neighbours have no triangle. Points in gaps that are no loop
// are not outliers.
std::vector<Index> points_beside(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                                 const std::vector<Triangle>& triangles);

}  // namespace rimline
