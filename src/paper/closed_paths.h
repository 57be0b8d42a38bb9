// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 3.1 (FIND_BOUNDARY_PATH) and the chromosome stack of Algorithm 3.2.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/score_boundary.h"

namespace rimline {

// Depth-first search for a closed path of candidates, written without recursion: a path may have as many
// points as there are candidates. One searcher serves any number of starts.
class ClosedPathSearcher {
 public:
  // `path_k` neighbours are looked at; a path may close once it has `threshold` points (section 3.2).
  ClosedPathSearcher(const Neighbours& neighbours, const std::vector<std::uint8_t>& candidate, int path_k,
                     int threshold);

  // FIND_BOUNDARY_PATH(start, start): the points of the path in its order, start first; empty where none
  // closes. `passed` is cleared for each start [ours: the paper does not say]. The point that finds the start
  // among its neighbours belongs to the path [ours: the listing returns before it is counted].
  std::vector<Index> find(Index start);

  // Neighbours looked at so far, over all starts: the measure of the work.
  std::int64_t steps() const { return steps_; }

 private:
  bool closes(Index point, Index start);

  const Neighbours& neighbours_;
  const std::vector<std::uint8_t>& candidate_;
  int path_k_;
  std::size_t threshold_;
  std::int64_t steps_ = 0;
  Index mark_ = 0;             // number of the current start
  std::vector<Index> passed_;  // the start that passed a point last
  std::vector<int> next_;      // next neighbour to try, for each point on the path
};

// A closed path as a chromosome: the ids of the bits set, ascending, and log e of eq. (3).
struct ClosedPath {
  std::vector<Index> ids;
  double log_fitness = 0;
};

struct ClosedPaths {
  std::vector<ClosedPath> best;  // distinct, fittest first, at most options.population
  std::size_t starts = 0, closed = 0, distinct = 0;
  std::int64_t steps = 0;
  bool bound_hit = false;
};

// One start per candidate, in an order shuffled by run.seed so that a bound on the work still sees all
// parts of the set; paths that repeat are dropped; the fittest are kept.
ClosedPaths find_closed_paths(const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run);

}  // namespace rimline
