// SPDX-License-Identifier: GPL-3.0-or-later
// The probability of each point to be on the boundary.
#pragma once

#include <vector>

#include "evidence/corner_histogram.h"
#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"
#include "rimline/score_boundary.h"
#include "surface/local_size.h"

namespace rimline {

// The probability of each point, by the rims through it and right before it. `rims`: all of them, gaps and
// all; `corners`: how usual wide corners are behind jagged rims.
std::vector<float> rate_points(const std::vector<Loop>& rims, const RimEvidence& evidence,
                               const LocalSizes& sizes, const CornerHistogram& corners,
                               const BoundaryScores& scores);

// The same, raised to the probability of points at planes that have cut the surface: points there that lie
// like the outermost points of a rim may be on the boundary, although triangles join them to the others.
std::vector<float> raise_at_cuts(std::vector<float> probability, const std::vector<Loop>& boundaries,
                                 const Samples& samples);

// eq. (3) of each loop, on the log score -log(1 - probability) of its points.
std::vector<Loop> with_fitness(std::vector<Loop> loops, const std::vector<float>& probability,
                               double length_exponent);

}  // namespace rimline
