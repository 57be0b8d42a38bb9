// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (3), by its logarithm.
#pragma once

#include <span>

#include "rimline/options.h"
#include "rimline/score_boundary.h"

namespace rimline {

// log e(C) of eq. (3) for the chromosome with these bits set; minus infinity for none. By the logarithm
// because 1 / p leaves the range of double for large k (docs/departures.md).
double log_fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options);

}  // namespace rimline
