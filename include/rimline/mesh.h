// SPDX-License-Identifier: GPL-3.0-or-later
// Results: loops and triangles over the ids of the points.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// A triangle of three distinct ids, counter-clockwise seen from the side the surface faces.
using Triangle = std::array<Index, 3>;

enum class LoopKind { Outer, Hole };

// "outer" or "hole", as in LOOPS.json.
const char* name(LoopKind kind);

// A closed, simple polyline along the boundary: each id appears once and the last joins the first.
struct Loop {
  std::vector<Index> points;
  LoopKind kind = LoopKind::Outer;
  double length = 0;       // of the closed polyline, in the unit of the input
  double fitness = 0;      // eq. (3), on the score that the preset uses
  Index component = 0;     // connected component of the surface it bounds, from 0
  double probability = 1;  // that the loop is a boundary, in [0, 1]; NaN where there is none: in the paper's
                           // presets, and for given loops
};

}  // namespace rimline
