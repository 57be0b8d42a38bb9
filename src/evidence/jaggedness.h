// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a rim is even or jagged at the scale of its edges.
#pragma once

#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// For each point of a closed loop how jagged the loop is for some way to both sides of it: 0 where even, 1
// where jagged. What was cut out of a finer surface ends in teeth all along, what was sampled up to its end
// in none. Less the turn that any closed loop makes, the mean turning of 65 corners in a row is up to 0.2 rad
// where samples end on the boundary, and 0.25 to 0.65 where they were cut (nine of ten, on known sets and
// analytic shapes).
std::vector<double> jaggedness(Points points, const std::vector<Index>& loop);

// For each point how even the loops through it are, 1 less the above; 0 where there is none. Loops of few
// points do not tell.
std::vector<double> evenness(Points points, const std::vector<std::vector<Index>>& loops,
                             const Run& run = {});

}  // namespace rimline
