// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the outer loop of each part among given loops.
#pragma once

#include <vector>

#include "pipeline/prepare.h"

namespace rimline::pipeline {

// Loops in ids of the arrangement, no point on two of them. A part of the surface has one outer loop. Of
// several in one part, which is what loops without a kind come to, the one of the largest box stays (of equal
// ones the longer, then the first), and the others become holes. [ours]
std::vector<Loop> with_one_outer_loop_a_part(std::vector<Loop> loops, const PreparedPoints& prepared,
                                             const Run& run);

// The same where all loops bound one part.
std::vector<Loop> with_one_outer_loop(std::vector<Loop> loops, const PreparedPoints& prepared);

}  // namespace rimline::pipeline
