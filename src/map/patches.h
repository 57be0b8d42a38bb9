// SPDX-License-Identifier: GPL-3.0-or-later
// Which points and loops make one patch.
#pragma once

#include <functional>
#include <vector>

#include "map/pinches.h"
#include "map/stars.h"
#include "rimline/mesh.h"

namespace rimline {

// One patch, in ids of its own.
struct PatchInput {
  std::vector<Index> points;  // the id of each in the whole, ascending
  Separated outline;          // the outer loop first; copies follow the points
};

struct Partition {
  std::vector<PatchInput> patches;  // by the first of their loops
  std::vector<Index> left_out;      // points that hang together with no loop, ascending
};

// Points hang together by the triangles of `surface` where there are any, else where each is in the other's
// cell, but not across a gap between loops, nor in a point where loops touch.
// Cells also tell where points go that no triangle joins to a loop; `stars` is called where there are such.
Partition partition(Index points, const std::function<const Stars&()>& stars, const std::vector<Loop>& loops,
                    const std::vector<Triangle>& surface);

}  // namespace rimline
