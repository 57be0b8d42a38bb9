// SPDX-License-Identifier: GPL-3.0-or-later
// The boundaries drawn anew, where noise or chance blurs which points are on them.
#pragma once

#include <vector>

#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"

namespace rimline {

struct SmoothedLoops {
  std::vector<Loop> loops;
  std::vector<float> probability;  // per point
};

// Draws each loop over a smooth curve (smooth_loop.h), and rates the points about it by how far out of it
// they lie. Loops that share no point keep it so: where two would meet, the later one stays as it was; so
// does one that would become half as long again. On clean points, and among random ones, the search knows
// better which points the loop goes through: only the probabilities are new. Where nothing blurs, all stays
// as it was.
SmoothedLoops smooth_loops(const std::vector<Loop>& loops, const std::vector<float>& probability,
                           const RimEvidence& evidence, const Run& run);

}  // namespace rimline
