// SPDX-License-Identifier: GPL-3.0-or-later
// Options of the genetic search.
#pragma once

#include <limits>

#include "base/model.h"
#include "search/fitness_weights.h"

namespace rimline {

struct SearchOptions {
  int population = 12;   // chromosomes per group of candidate triangles [option]
  int generations = 30;  // at most; a group stops when all members agree. 0: climbing alone [option]
  bool is_greedy = false;  // each candidate by its own size
  double doubtful = model::candidate_least;  // least log_ratio of a candidate at the rim
  // A triangle at the rim whose log_odds_alone() is larger is a candidate whatever its size.
  double least_odds = std::numeric_limits<double>::infinity();
  FitnessWeights weights;
};

}  // namespace rimline
