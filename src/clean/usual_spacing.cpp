// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/usual_spacing.h"

#include <algorithm>

#include "base/lanes.h"
#include "base/model.h"
#include "base/multiversioning.h"
#include "base/parallel.h"

namespace rimline {
namespace {

// Sorts each lane by exchanges of neighbours, which have no branch.
RIMLINE_WIDE void sort_lanes(Lanes* rows, int count) {
  for (int round = 0; round < count; ++round) {
    for (int i = round % 2; i + 1 < count; i += 2) {
      Lanes low;  // loops of one choice each, which become vector instructions
      for (int l = 0; l < lanes; ++l) low[l] = std::min(rows[i][l], rows[i + 1][l]);
      for (int l = 0; l < lanes; ++l) rows[i + 1][l] = std::max(rows[i][l], rows[i + 1][l]);
      rows[i] = low;
    }
  }
}

}  // namespace

std::vector<double> usual_spacing(const Neighbours& neighbours, const std::vector<double>& spacing,
                                  const Run& run) {
  const int count = std::min(model::few_neighbours, neighbours.k);
  std::vector<double> usual(spacing.size());
  parallel_slices(spacing.size(), Stage::Neighbours, run, [&](std::size_t begin, std::size_t end) {
    Lanes around[model::few_neighbours] = {};
    for (auto first = static_cast<Index>(begin); first < static_cast<Index>(end); first += lanes) {
      const int used = std::min(lanes, static_cast<Index>(end) - first);
      for (int l = 0; l < used; ++l) {
        const auto ids = neighbours.of(first + l, count);
        for (int j = 0; j < count; ++j) around[j][l] = spacing[ids[j]];
      }
      sort_lanes(around, count);
      for (int l = 0; l < used; ++l) usual[first + l] = around[count / 2][l];
    }
  });
  return usual;
}

}  // namespace rimline
