// SPDX-License-Identifier: GPL-3.0-or-later
// From candidates to the boundary: section 3 of the paper.
#pragma once

#include <vector>

#include "rimline/history.h"
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
  SearchHistory history;
};

// Algorithm 3.1 from every candidate, Algorithm 3.2 on the paths, and the order of the winner's points
// (order_loop in src/paper/order.h, ours). The winner is the fittest chromosome whose loop closes: it goes
// round the chromosome's band, or has more than options.path_k points. Where none of the fittest closes, it
// is the best initial path that does. The result depends on run.seed. Throws NoClosedLoop, with the
// candidates as ids, where there is none.
GeneticLoop find_genetic_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run);

// Eq. (3) of a set of points, as the score form says; at most the largest double.
double fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options);

// Length of the closed polyline.
double loop_length(Points points, std::span<const Index> loop);

}  // namespace rimline
