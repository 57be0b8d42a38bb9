// SPDX-License-Identifier: GPL-3.0-or-later
// What the genetic search is given.
#pragma once

#include "search/fitness.h"

namespace rimline {

struct SearchOptions {
  int population = 12;    // chromosomes per group of doubtful triangles
  int generations = 30;   // most of them; a group stops where all agree. 0 leaves the greedy choice
  double doubtful = 0.1;  // least log_ratio of a triangle that is doubtful where the rim reaches it
  FitnessModel weights;
};

}  // namespace rimline
