// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/lanes.h"
#include "base/multiversioning.h"
#include "base/parallel.h"
#include "points/kd_tree.h"
#include "points/leaf_search.h"

namespace rimline {
namespace {

constexpr int points_in_leaf = 40;          // at most; measured
constexpr std::size_t leaves_in_task = 64;  // about a thousand points: long enough to hide its cost
constexpr int most_averaged = 6;            // distances to neighbours, for the spacing

// The mean of `count` >= 1 square roots in each lane.
RIMLINE_WIDE void average_roots(const Lanes* squared, int count, Lanes& mean) {
  for (int l = 0; l < lanes; ++l) {
    double sum = 0;
    int j = 0;
    do {
      sum += std::sqrt(squared[j++][l]);
    } while (j < count);
    mean[l] = sum / count;
  }
}

}  // namespace

Neighbours find_neighbours(Points points, int k, const Run& run) {
  if (points.size() < 2) {
    throw Error(ErrorCode::TooFewPoints,
                "neighbours need at least 2 points, there are " + std::to_string(points.size()));
  }
  run.progress(Stage::Neighbours, 0, points.size());
  Neighbours result;
  result.k = static_cast<int>(std::min<std::size_t>(k, points.size() - 1));
  result.ids.resize(points.size() * result.k);  // the search writes all
  const KdTree tree(points, points_in_leaf, run);
  parallel_slices(
      tree.leaf_count(), Stage::Neighbours, run,
      [&](std::size_t first, std::size_t last) {
        LeafSearch leaf_search(tree, result.k);
        for (std::size_t leaf = first; leaf < last; ++leaf) leaf_search.search(leaf, result);
      },
      leaves_in_task);
  return result;
}

std::vector<double> local_spacing(Points points, const Neighbours& neighbours, const Run& run) {
  const int nearest = std::min(most_averaged, neighbours.k);
  std::vector<double> spacing(neighbours.size());
  parallel_slices(spacing.size(), Stage::Neighbours, run, [&](std::size_t begin, std::size_t end) {
    std::array<Lanes, most_averaged> squared{};
    Lanes mean;
    for (std::size_t first = begin; first < end; first += lanes) {
      const int count = static_cast<int>(std::min<std::size_t>(lanes, end - first));
      for (int l = 0; l < count; ++l) {
        const auto i = static_cast<Index>(first + l);
        const auto ids = neighbours.of(i, nearest);
        for (int j = 0; j < nearest; ++j) squared[j][l] = squared_distance(points[i], points[ids[j]]);
      }
      average_roots(squared.data(), nearest, mean);
      std::copy(mean.number, mean.number + count, &spacing[first]);
    }
  });
  return spacing;
}

}  // namespace rimline
