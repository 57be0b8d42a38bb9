// SPDX-License-Identifier: GPL-3.0-or-later
// Loops given by the caller in place of found ones.
#pragma once

#include <vector>

#include "pipeline/prepare.h"
#include "rimline/boundary_loops.h"
#include "rimline/score_boundary.h"

namespace rimline::pipeline {

// Throws BadOption for loops of fewer than three points, or with ids that the input does not have; and, with
// the ids, for points that a loop passes twice or that are on two loops: a boundary passes each of its points
// once.
void check_given_loops(const std::vector<Loop>& loops, std::size_t point_count);

// The given loops in ids of the arrangement, with lengths and fitness. Throws BadOption, naming points of the
// loops that are not in use.
std::vector<Loop> arrange_loops(std::vector<Loop> given, const PreparedPoints& prepared,
                                const BoundaryScores& scores, const LoopOptions& options);

// The labels, with exactly the points of these loops on the boundary.
std::vector<PointLabel> label_boundary(std::vector<PointLabel> label, const std::vector<Loop>& loops);

}  // namespace rimline::pipeline
