// SPDX-License-Identifier: GPL-3.0-or-later
// The genetic search for the rim: which of the doubtful triangles belong to the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/complex.h"
#include "exact/doubt.h"
#include "exact/local_size.h"
#include "exact/rim.h"
#include "exact/rim_energy.h"
#include "rimline/run.h"

namespace rimline::exact {

struct RimSearchOptions {
  int population = 12;    // chromosomes per group of doubtful triangles
  int generations = 30;   // most of them; a group stops where all agree. 0 leaves the greedy choice
  double doubtful = 0.1;  // least log_ratio of a triangle that is doubtful where the rim reaches it
  RimWeights weights;
};

struct RimSearchResult {
  Kept kept;
  std::size_t doubtful = 0;  // triangles: the bits of all chromosomes
  std::size_t groups = 0;
  double greedy = 0, best = 0;                     // fitness
  std::vector<double> history_best, history_mean;  // per generation, summed over the groups
};

// A chromosome says of each doubtful triangle whether it is kept. The rim of any set of triangles is a set of
// closed loops, so any chromosome is a closed boundary, and so is what crossover and mutation make of it:
// exchanging triangles adds (modulo 2) the boundary of what was exchanged.
//
// Doubtful triangles that share no vertex with others of their group do not influence each other, so each
// group has a population of its own.
//
// Triangles at a vertex marked in `barred` are not doubted: those around gaps that are no boundary. But what
// is plainly too large is doubted there, too.
//
// The complex, which must stay as it is, and the run must outlive it.
class RimSearch {
 public:
  RimSearch(const Complex& complex, LocalSizes& sizes, const std::vector<std::uint8_t>& barred,
            const RimSearchOptions& options, const Run& run);

  // `evenness`: of a rim known before at each vertex, 0 to 1; 0 where it is on none. Empty: not known.
  RimSearchResult find(const std::vector<double>& evenness) const;
  // Once more, with the evenness of the rim found `before`. Where no rim is even it would find the same, which
  // is taken over.
  RimSearchResult find_again(const std::vector<double>& evenness, const Kept& before) const;

 private:
  Doubt with(const std::vector<double>& evenness) const;
  template <class Wanted>
  RimSearchResult search(const Doubt& doubt, Kept kept, const Wanted& wanted) const;

  const Complex& complex_;
  RimSearchOptions options_;
  const Run& run_;
  Doubt doubt_;
  Corners corners_;
  Groups groups_;
};

}  // namespace rimline::exact
