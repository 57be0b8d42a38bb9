// SPDX-License-Identifier: GPL-3.0-or-later
// What the genetic search is given.
#pragma once

#include <limits>

#include "base/model.h"
#include "search/fitness_weights.h"

namespace rimline {

struct SearchOptions {
  int population = 12;   // chromosomes per group of candidate triangles [option]
  int generations = 30;  // most of them; a group stops where all agree. 0 leaves the greedy choice [option]
  double doubtful =
      model::candidate_least;  // least log_ratio of a triangle that is doubtful where the rim reaches it
  // Or its least log_odds_alone().
  double least_odds = std::numeric_limits<double>::infinity();
  FitnessWeights weights;
};

}  // namespace rimline
