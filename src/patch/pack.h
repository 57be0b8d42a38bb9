// SPDX-License-Identifier: GPL-3.0-or-later
// Packs the maps of several patches in one plane.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// Moves the maps of patches 0, 1, ... apart, each in its own box: the tallest first, in rows about as wide as
// the whole is high, with a tenth of a box between neighbours. The patch of most vertices is not moved,
// because it has the least room for rounding; the others lie to its right and above. `patch`: of each vertex,
// or none. `least`: of each gap, as a share of the side of a square that has the area of all boxes.
void pack_patches(std::span<const Index> patch, std::size_t patch_count, std::vector<UV>& uv,
                  double least = 0);

}  // namespace rimline
