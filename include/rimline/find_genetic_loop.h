// SPDX-License-Identifier: GPL-3.0-or-later
// From candidates to the boundary: section 3 of the paper.
#pragma once

#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/report.h"
#include "rimline/score_boundary.h"

namespace rimline {

// What Algorithms 3.1 and 3.2 return.
struct GeneticLoop {
  Loop loop;                  // the winner as a simple, closed polyline
  std::vector<Index> winner;  // the winning chromosome: ids of the bits set, ascending
  SearchSummary search;
};

// Algorithm 3.1 from every candidate, Algorithm 3.2 on the paths, and the order of the winner's points
// (order_loop in src/paper/order.h, ours). The result depends on run.seed. Throws NoClosedLoop, with the
// candidates as ids, where no path closes.
GeneticLoop find_genetic_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run);

// Eq. (3) of a set of points, as the score form says; at most the largest double.
double fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options);

// Length of the closed polyline.
double loop_length(Points points, std::span<const Index> loop);

}  // namespace rimline
