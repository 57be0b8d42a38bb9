// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 3.2 (APPLY_GENETIC_ALGORITHM), from its initial population on.
#pragma once

#include <cstdint>
#include <vector>

#include "paper/closed_paths.h"
#include "rimline/history.h"
#include "rimline/report.h"

namespace rimline {

// A binary string with a bit per sample point (section 3.2).
class Chromosome {
 public:
  explicit Chromosome(std::size_t length) : words_((length + 63) / 64) {}
  Chromosome(std::size_t length, std::span<const Index> ids) : Chromosome(length) {
    for (const Index id : ids) flip(id);
  }

  void flip(Index bit) { words_[bit / 64] ^= std::uint64_t{1} << (bit % 64); }
  // Ids of the bits set, ascending.
  std::vector<Index> ids() const;
  // Swaps all bits from `first` on.
  static void exchange_tails(Chromosome& a, Chromosome& b, std::size_t first);

 private:
  std::vector<std::uint64_t> words_;
};

struct Evolution {
  std::vector<ClosedPath>
      fittest;  // distinct chromosomes of all generations, best first, at most `population`
  std::vector<Generation> history;  // of the initial population and of each generation after it
  SearchHistory best;               // the best chromosome of each of them
};

// K generations of the simple genetic algorithm of section 3.1: selection in proportion to eq. (3), one-point
// crossover of random pairs, mutation of single bits (candidates only: interior points always have bit 0).
Evolution evolve(const std::vector<ClosedPath>& initial, const BoundaryScores& scores,
                 const LoopOptions& options, const Run& run);

}  // namespace rimline
