// SPDX-License-Identifier: GPL-3.0-or-later
// Separates loops that touch in a point, for the meshing; the result joins them again.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Where two loops share a point, the surface has two separate wedges there, and its true outline continues
// from one loop to the other (from an outer loop to itself where two parts touch in a tip). Each visit but
// the first gets a copy of the point, so that the loops become simple and disjoint.
struct Separated {
  std::vector<Loop> loops;      // in the order of their first pass; lengths are not kept
  std::vector<Index> original;  // of copy point_count + i
};

Separated separate_pinches(const std::vector<Loop>& loops, Index point_count);

}  // namespace rimline
