// SPDX-License-Identifier: GPL-3.0-or-later
// The maps of several patches in one plane.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// Moves the maps of patches 0, 1, ... apart, each in its own box: the tallest first, in rows about as wide as
// the whole is high, a tenth of a box between neighbours. The patch of most vertices stays
// where it is to the last bit, as it has the most crowded places, with the others to its right and above.
// `patch` is that of each vertex, or none.
void pack_patches(std::span<const Index> patch, std::size_t patch_count, std::vector<UV>& uv);

}  // namespace rimline
