// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "paper/band.h"

namespace rimline {
namespace {

Index common_ancestor(const Forest& forest, Index a, Index b) {
  while (a != b) {
    if (forest.depth[a] < forest.depth[b]) std::swap(a, b);
    a = forest.parent[a];
  }
  return a;
}

std::vector<Index> cycle_of(const Forest& forest, const Join& join, std::span<const Index> ids) {
  const Index top = common_ancestor(forest, join.a, join.b);
  std::vector<Index> up, down;
  for (Index p = join.a; p != top; p = forest.parent[p]) up.push_back(ids[p]);
  for (Index p = join.b; p != top; p = forest.parent[p]) down.push_back(ids[p]);
  up.push_back(ids[top]);
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

// Indices in the set, by falling score.
std::vector<Index> by_score(const BoundaryScores& scores, std::span<const Index> ids) {
  std::vector<Index> positions(ids.size());
  std::iota(positions.begin(), positions.end(), 0);
  std::stable_sort(positions.begin(), positions.end(),
                   [&](Index a, Index b) { return scores.log_score[ids[a]] > scores.log_score[ids[b]]; });
  return positions;
}

// A cycle of the band: one join, and the paths of the forest to its ends.
struct Cycle {
  Index join;
  double length, cost;
};

// All essential cycles, or all cycles where none is essential.
std::vector<Cycle> cycles_of(const Band& band, const Forest& forest, bool round) {
  const std::vector<std::uint8_t> goes_round =
      round ? going_round(band, forest) : std::vector<std::uint8_t>{};
  std::vector<Cycle> cycles;
  for (Index j = 0; j < static_cast<Index>(band.joins.size()); ++j) {
    const auto& [a, b, length, cost] = band.joins[j];
    if (forest.parent[a] == b || forest.parent[b] == a) continue;
    if (round && goes_round[j] == 0) continue;
    const Index top = common_ancestor(forest, a, b);
    cycles.push_back({j, forest.length[a] + forest.length[b] - 2 * forest.length[top] + length,
                      forest.cost[a] + forest.cost[b] - 2 * forest.cost[top] + cost});
  }
  return cycles;
}

// Share of the points of a band that are on the loop or joined to a point of it.
double share_beside(const Band& band, std::span<const Index> ids, const std::vector<Index>& loop) {
  std::vector<char> beside(ids.size(), 0);
  for (const Index id : loop) {
    const auto at = static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    beside[at] = 1;
    for (const Index j : band.joins_of[at]) beside[band.other_end(j, at)] = 1;
  }
  return static_cast<double>(std::count(beside.begin(), beside.end(), 1)) / static_cast<double>(ids.size());
}

}  // namespace

OrderedLoop order_loop(Points points, const Neighbours& neighbours, int path_k, const BoundaryScores& scores,
                       std::span<const Index> ids) {
  OrderedLoop result;
  if (ids.size() < 3) return result;
  const Band band = make_band(points, neighbours, path_k, scores, ids);
  const Forest forest = cheapest_ways(band, by_score(scores, ids));
  std::vector<Cycle> cycles = cycles_of(band, forest, true);
  const bool is_round = !cycles.empty();
  if (!is_round) cycles = cycles_of(band, forest, false);
  double longest = 0;
  for (const Cycle& cycle : cycles) longest = std::max(longest, cycle.length);
  const Cycle* best = nullptr;
  for (const Cycle& cycle : cycles) {
    if (cycle.length < longest / 2) continue;
    if (best == nullptr || cycle.cost < best->cost) best = &cycle;
  }
  if (best == nullptr) return result;
  result.points = cycle_of(forest, band.joins[best->join], ids);
  constexpr double enough = 2.0 / 3;
  result.goes_round = is_round && share_beside(band, ids, result.points) >= enough;
  return result;
}

}  // namespace rimline
