// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse points beside a dense surface: outliers that are so many that they are one another's neighbours.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Marks (1) the points of groups of two and more that gaps wider than the smaller spacing of both ends part
// from all others, of which most are sparse beside the points around them and most lie on no surface at their
// own scale: the points of a coarse part of a surface do. `spacing`: local_spacing().
std::vector<char> lies_in_sparse_group(Points points, const Neighbours& neighbours,
                                       const std::vector<double>& spacing, const Run& run);

}  // namespace rimline
