// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/neighbours.h"

#include <algorithm>
#include <string>

#include "neighbours/kd_tree.h"
#include "neighbours/leaf_search.h"
#include "parallel.h"

namespace rimline {
namespace {

constexpr int points_in_leaf = 32;          // at most; measured
constexpr std::size_t leaves_in_task = 64;  // about a thousand points: long enough to hide its cost

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
  const int nearest = std::min(6, neighbours.k);
  std::vector<double> spacing(neighbours.size());
  parallel_for_each(spacing.size(), Stage::Neighbours, run, [&](Index i) {
    double sum = 0;
    for (int j = 0; j < nearest; ++j) sum += distance_to(points, neighbours, i, j);
    spacing[i] = sum / nearest;
  });
  return spacing;
}

}  // namespace rimline
