// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2: tests every point, and checks the assumptions.
#pragma once

#include <string>
#include <vector>

#include "pipeline/prepare.h"
#include "rimline/score_boundary.h"

namespace rimline::pipeline {

// Throws NoClosedLoop where the points lie on lines: no plane is near any of them.
BoundaryScores score(const PreparedPoints& prepared, const Options& options, const Run& run,
                     StageClock& clock);

AssumptionSummary summarize_assumptions(const BoundaryScores& scores, int k, int sectors);
std::vector<std::string> warn_of_assumptions(const AssumptionSummary& assumptions, int k, int sectors);

}  // namespace rimline::pipeline
