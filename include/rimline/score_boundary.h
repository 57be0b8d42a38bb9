// SPDX-License-Identifier: GPL-3.0-or-later
// Which points may lie on the boundary: section 2 of the paper.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The chi-square test of every point.
struct BoundaryScores {
  // -log p (natural logarithm), p the p-value of Pearson's statistic: at least 0, finite for any k and r. It
  // is the logarithm of eq. (2), and the score of every later stage.
  std::vector<double> log_score;
  std::vector<std::uint8_t> candidate;  // 1 where p <= significance
  std::vector<float> delta;             // lambda_2 / (lambda_1 + lambda_2 + lambda_3), Assumption 2.4
};

// Section 2.2 to 2.3: least squares plane, h = sigma after pi, sectors, eq. (1), p-value. The test takes the
// nearest options.k of the neighbours, or all where there are fewer. Throws TooFewPoints for fewer than 3.
BoundaryScores score_boundary(Points points, const Neighbours& neighbours, const BoundaryOptions& options,
                              const Run& run);

// p from its negative logarithm; 0 below the least double.
double p_value(double log_score);

// Eq. (2) as the options choose it: 1 / p (at most the largest double), 1 / max(p, score_cap) or -log p.
double score(double log_score, const LoopOptions& options);

// Its logarithm.
double log_of_score(double log_score, const LoopOptions& options);

}  // namespace rimline
