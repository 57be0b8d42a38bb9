// SPDX-License-Identifier: GPL-3.0-or-later
// Distributes the triangles of the whole surface to patches.
#pragma once

#include <cstddef>
#include <vector>

#include "patch/partition.h"

namespace rimline {

// The triangles of each patch, in its ids, in their order. A triangle belongs to the patch that has all of
// its corners; if corners are points of several patches, the other corners decide. Triangles with corners in
// different patches, or without a corner in a single patch, are left out. `points`: of the whole.
std::vector<std::vector<Triangle>> share_out(const std::vector<Triangle>& triangles, std::size_t points,
                                             const std::vector<PatchInput>& patches);

}  // namespace rimline
