// SPDX-License-Identifier: GPL-3.0-or-later
// Partitions points and loops into patches.
#pragma once

#include <functional>
#include <vector>

#include "local/star.h"
#include "patch/pinches.h"
#include "rimline/mesh.h"

namespace rimline {

// One patch, in ids of its own.
struct PatchInput {
  std::vector<Index> points;  // the id of each in the whole, ascending
  Separated outline;          // the outer loop first; copies follow the points
  bool touches = false;       // loops or components of it meet in a point
};

struct Partition {
  std::vector<PatchInput> patches;  // in the order of their first loops
  std::vector<Index> left_out;      // points connected to no loop, ascending
};

// Connected components. A triangle of `surface` joins its points. Without triangles, two points are joined if
// each is in the cell of the other. Nothing is joined across a gap between loops, or where loops touch.
// Points that no triangle joins to a loop are assigned by their cells; `stars` is called only for them.
// A part without a loop that closes upon itself is left out whole.
Partition partition(Index points, const std::function<const Stars&()>& stars, const std::vector<Loop>& loops,
                    const std::vector<Triangle>& surface);

// Removes points, ascending and on no loop, from the patches.
Partition without_points(Partition parts, const std::vector<Index>& points);

}  // namespace rimline
