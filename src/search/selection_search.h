// SPDX-License-Identifier: GPL-3.0-or-later
// The genetic search for the rim: which of the candidate triangles belong to the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/run.h"
#include "search/candidates.h"
#include "search/fitness.h"
#include "search/groups.h"
#include "search/search_options.h"
#include "surface/local_size.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

struct SearchResult {
  Selection selected;
  std::size_t doubtful = 0;  // candidate triangles: bits of a chromosome
  std::size_t groups = 0;
  double greedy = 0, best = 0;                     // fitness
  std::vector<double> history_best, history_mean;  // per generation, summed over the groups
};

// A chromosome has one bit per candidate triangle: selected or not. The boundary of any set of triangles is a
// set of closed loops, so every chromosome is a closed boundary, also after crossover and mutation:
// exchanging triangles adds their boundary modulo 2.
//
// Candidates of different groups share no vertex and do not influence each other, so each group has its own
// population.
//
// Triangles at a vertex marked in `excluded` (around gaps that are no boundary) are no candidates, unless
// they are plainly too large.
//
// The set, which must stay as it is, and the run must outlive it.
class SelectionSearch {
 public:
  SelectionSearch(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                  const std::vector<std::uint8_t>& excluded, const SearchOptions& options, const Run& run);

  // `evenness`: of a rim known before at each vertex, 0 to 1; 0 where it is on none. Empty: not known.
  SearchResult find(const std::vector<double>& evenness) const;
  // Searches again, with the evenness of the rims found `before`. Groups where no rim is even keep that
  // result.
  SearchResult find_again(const std::vector<double>& evenness, const Selection& before) const;

 private:
  Candidates with(const std::vector<double>& evenness) const;
  template <class Wanted>
  SearchResult search(const Candidates& candidates, Selection selected, const Wanted& wanted) const;

  const TriangleSet& set_;
  SearchOptions options_;
  const Run& run_;
  Candidates candidates_;
  FanCorners corners_;
  CandidateGroups groups_;
};

}  // namespace rimline
