// SPDX-License-Identifier: GPL-3.0-or-later
// The boundaries redrawn, where noise or random sampling makes their points uncertain.
#pragma once

#include <vector>

#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"

namespace rimline {

struct SmoothedLoops {
  std::vector<Loop> loops;
  std::vector<float> probability;  // per point
};

// Redraws each loop along a smooth curve (smooth_loop.h), and rates the points near it by their distance
// outwards. Disjoint loops stay disjoint: where two would meet, the later one keeps its old course, and so
// does a loop that would become half as long again. On clean points, and on random ones, the search knows
// better which points are on the loop: only the probabilities change. Where nothing is uncertain, nothing
// changes.
SmoothedLoops smooth_loops(const std::vector<Loop>& loops, const std::vector<float>& probability,
                           const RimEvidence& evidence, const Run& run);

}  // namespace rimline
