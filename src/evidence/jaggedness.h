// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a rim is even or jagged at the scale of its edges.
#pragma once

#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Jaggedness of a closed loop around each of its points: 0 where even, 1 where jagged. A rim that was cut out
// of a finer surface has teeth everywhere, a rim sampled up to its end has none. Less the turning of any
// closed loop, the mean turning of 65 consecutive corners is up to 0.2 rad where samples end on the boundary,
// and 0.25 to 0.65 where they were cut (nine of ten, on known sets and analytic shapes).
std::vector<double> jaggedness(Points points, const std::vector<Index>& loop);

// Evenness of the loops through each point, 1 less the above; 0 where there is none. Loops of few points do
// not count.
std::vector<double> evenness(Points points, const std::vector<std::vector<Index>>& loops,
                             const Run& run = {});

}  // namespace rimline
