// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3 as an experiment: Algorithms 3.1 and 3.2 on one set, in all score forms and under changes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "paper/closed_paths.h"
#include "paper/point_set.h"
#include "rimline/find_genetic_loop.h"
#include "rimline/options.h"
#include "rimline/score_boundary.h"

namespace rimline::bench {

// The test and Algorithm 3.1 on a set: they do not depend on the form of the score, nor on the seed.
struct Paths {
  BoundaryScores scores;
  ClosedPaths found;  // all distinct ones
};
Paths find_paths(const PointSet& set, BoundaryScores scores, const LoopOptions& options);

// The fittest `options.population` of them, by the score form of the options.
ClosedPaths fittest_of(const Paths& paths, const LoopOptions& options);

// One run of Algorithm 3.2: "e_0" and "e_K", the best e(C) of the generations 0 and K; "winner" and "loop" in
// points; "from" and "rank"; "covers", the share of the true rim with a point of the loop within a spacing,
// and "on_rim", the same of the loop by the rim; "box", the loop's place in the box of the set.
nlohmann::ordered_json measure_run(const PointSet& set, const Paths& paths, const LoopOptions& options,
                                   std::uint64_t seed);

// The best path of Algorithm 3.1 by e(C), and the one that covers most of the true rim.
nlohmann::ordered_json measure_best_paths(const PointSet& set, const Paths& paths,
                                          const LoopOptions& options);

// For caps from 0.1 to 1e-12, and for eq. (2) as printed and its logarithm: what the best path covers.
nlohmann::ordered_json measure_plateau(const PointSet& set, const Paths& paths, const LoopOptions& options);

}  // namespace rimline::bench
