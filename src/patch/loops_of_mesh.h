// SPDX-License-Identifier: GPL-3.0-or-later
// Tells the rims of a mesh that are boundaries from gaps between samples.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// A rim and the loop found along it.
struct MatchedRim {
  std::vector<Index> points;
  Index loop = none;     // the loop that has most of its points, or none
  bool is_open = false;  // whether it is taken for a boundary
};

// A rim is taken for a boundary where at least half of its points lie on loops, or where it has more points
// of a loop than any other rim. Loops may have been drawn through points beside the rim.
std::vector<MatchedRim> match_rims(std::vector<std::vector<Index>> rims, const std::vector<Loop>& loops,
                                   std::size_t points);

}  // namespace rimline
