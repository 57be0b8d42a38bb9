// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 3.2 from the paths of Algorithm 3.1 to the loop.
#pragma once

#include "paper/closed_paths.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {

// The second half of find_genetic_loop(): `paths`, at least one, must belong to `scores` and `options`.
GeneticLoop breed_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                       const ClosedPaths& paths, const LoopOptions& options, const Run& run);

}  // namespace rimline
