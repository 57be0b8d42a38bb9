// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 3.2 from the paths of Algorithm 3.1 to the loop.
#pragma once

#include "paper/closed_paths.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {

// What find_genetic_loop() does once the paths are found; they are the ones of `scores` and `options`, at
// least one.
GeneticLoop breed_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                       const ClosedPaths& paths, const LoopOptions& options, const Run& run);

}  // namespace rimline
