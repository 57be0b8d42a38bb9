// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that touch in a point: taken apart there for the work, put together again in the result.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Where two loops share a point, the surface has two separate wedges there, and its true outline runs from
// one loop over into the other (from outer loop to outer loop it stays: two parts touch in a tip). Each pass
// but the first gets a copy of the point, so that the loops become simple and disjoint.
struct Separated {
  std::vector<Loop> loops;      // in the order of their first pass; lengths are not kept
  std::vector<Index> original;  // of copy point_count + i
};

Separated separate_pinches(const std::vector<Loop>& loops, Index point_count);

}  // namespace rimline
