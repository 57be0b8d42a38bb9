// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/loop_kinds.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "patch/partition.h"
#include "points/morton.h"

namespace rimline::pipeline {
namespace {

bool is_outer(const Loop& loop) { return loop.kind == LoopKind::Outer; }

double box_diagonal(const Loop& loop, const std::vector<Point>& points) {
  PointBox box;
  for (const Index id : loop.points) box.add(points[id]);
  return distance(box.low, box.high);
}

// `part`: the loops that bound one part, by their place in `loops`.
void keep_one_outer(std::vector<std::size_t> part, const std::vector<Point>& points,
                    std::vector<Loop>& loops) {
  std::erase_if(part, [&](std::size_t l) { return !is_outer(loops[l]); });
  if (part.size() < 2) return;
  std::sort(part.begin(), part.end());  // in the order in which they were given
  const auto size = [&](std::size_t l) { return std::pair(box_diagonal(loops[l], points), loops[l].length); };
  const auto largest = std::max_element(part.begin(), part.end(),
                                        [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  for (const std::size_t l : part) {
    if (l != *largest) loops[l].kind = LoopKind::Hole;
  }
}

}  // namespace

std::vector<Loop> with_one_outer_loop_a_part(std::vector<Loop> loops, const PreparedPoints& prepared,
                                             const Run& run) {
  if (std::count_if(loops.begin(), loops.end(), is_outer) < 2) return loops;
  const std::vector<Point>& points = prepared.points();
  std::vector<std::size_t> loop_at(points.size(), loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (const Index id : loops[l].points) loop_at[id] = l;
  }
  std::optional<Stars> stars;
  const auto find = [&]() -> const Stars& {
    if (!stars) stars = find_weighted_stars(points, prepared.neighbours, run);
    return *stars;
  };
  const Partition parts = partition(static_cast<Index>(points.size()), find, loops, {});
  for (const PatchInput& patch : parts.patches) {
    std::vector<std::size_t> part;
    for (const Loop& loop : patch.outline.loops) part.push_back(loop_at[patch.points[loop.points[0]]]);
    keep_one_outer(std::move(part), points, loops);
  }
  return loops;
}

std::vector<Loop> with_one_outer_loop(std::vector<Loop> loops, const PreparedPoints& prepared) {
  std::vector<std::size_t> all(loops.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  keep_one_outer(std::move(all), prepared.points(), loops);
  return loops;
}

}  // namespace rimline::pipeline
