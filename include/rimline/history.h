// SPDX-License-Identifier: GPL-3.0-or-later
// The best chromosome of each generation of Algorithm 3.2.
#pragma once

#include <string>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// The best chromosome of a generation; generation 0 is the initial population.
struct BestChromosome {
  int generation = 0;
  double fitness = 0;         // e(C) of eq. (3), in the score form of the options
  std::vector<Index> points;  // the bits that are set, ascending
};

// Every `stride`-th generation from 0 on. The stride is 1, and doubled as often as it takes to keep no more
// than `most_points` points in all.
class SearchHistory {
 public:
  static constexpr std::size_t most_points = 2'000'000;

  // Takes the best of the next generation.
  void add(BestChromosome best);

  int stride() const { return stride_; }
  const std::vector<BestChromosome>& generations() const { return generations_; }
  // Gives every point the id `ids[point]`.
  void rename(const std::vector<Index>& ids);

 private:
  int stride_ = 1;
  std::size_t points_ = 0;
  std::vector<BestChromosome> generations_;
};

// HISTORY.json, docs/formats.md. `point_count` is that of the input.
std::string history_to_json(const SearchHistory& history, std::size_t point_count);

}  // namespace rimline
