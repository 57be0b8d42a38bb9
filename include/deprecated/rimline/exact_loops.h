// SPDX-License-Identifier: GPL-3.0-or-later
// The names of version 0.1 for what rimline/boundary_loops.h declares. To be removed after 0.2.
#pragma once

#include <utility>
#include <vector>

#include "rimline/boundary_loops.h"

namespace rimline {

using ExactLoopOptions = BoundaryLoopOptions;
using BoundarySurvey = BoundaryLoops;
using RimSearchSummary = SelectionSummary;

[[deprecated("use find_boundary_loops")]] inline BoundaryLoops find_exact_loops(
    Points points, const Neighbours& neighbours, const BoundaryScores& scores,
    const BoundaryLoopOptions& options, double length_exponent, const Run& run) {
  return find_boundary_loops(points, neighbours, scores, options, length_exponent, run);
}

[[deprecated("use find_boundary_loops")]] inline BoundaryLoops find_exact_loops(
    Points points, const Neighbours& neighbours, std::vector<double> spacing, const BoundaryScores& scores,
    const BoundaryLoopOptions& options, double length_exponent, const Run& run) {
  return find_boundary_loops(points, neighbours, std::move(spacing), scores, options, length_exponent, run);
}

}  // namespace rimline
