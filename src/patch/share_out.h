// SPDX-License-Identifier: GPL-3.0-or-later
// Which patch a triangle of the whole surface belongs to.
#pragma once

#include <cstddef>
#include <vector>

#include "patch/partition.h"

namespace rimline {

// The triangles of each patch, in its ids, in their order. A triangle belongs to the patch that has all of
// its corners; where corners are points of several patches, the others decide. Triangles that no patch has
// whole, or that have no corner in one patch alone, are left out. `points`: of the whole.
std::vector<std::vector<Triangle>> share_out(const std::vector<Triangle>& triangles, std::size_t points,
                                             const std::vector<PatchInput>& patches);

}  // namespace rimline
