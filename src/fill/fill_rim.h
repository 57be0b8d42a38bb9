// SPDX-License-Identifier: GPL-3.0-or-later
// Fills a hole: triangles over its rim, flipped in space, with new vertices on request.
#pragma once

#include <span>
#include <vector>

#include "fill/polygon.h"
#include "rimline/run.h"

namespace rimline {

struct RimFill {
  std::vector<Triangle> triangles;  // ids are positions on the rim; from rim.size() on, those of `added`
  std::vector<Point> added;
};

// Fills a rim whose fill is on its left: least area (triangulate_polygon), then flips by the opposite-angle
// rule; the rim's edges stay. `spacing` (one per rim point) may be empty; else vertices are added until
// triangles have that size (Liepa 2003, section 4, at most `most_added`), and moved to the mean of their
// neighbours, the discrete membrane over the rim. Empty where `may_join` allows no triangulation.
RimFill fill_rim(Points rim, std::span<const double> spacing, std::size_t most_added, const MayJoin& may_join,
                 const Run& run);

}  // namespace rimline
