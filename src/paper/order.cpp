// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/order.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

namespace rimline {
namespace {

struct Join {
  Index a, b;  // positions in the set, a < b
  double length, cost;
};

// The set as a graph: its points by position in `ids`, joined where one is among the other's neighbours.
struct Band {
  std::vector<Join> joins;
  std::vector<std::vector<Index>> joins_of;  // positions in `joins`
};

Band make_band(Points points, const Neighbours& neighbours, int path_k, const BoundaryScores& scores,
               std::span<const Index> ids) {
  Band band;
  const auto position = [&](Index id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? static_cast<Index>(at - ids.begin()) : none;
  };
  for (Index a = 0; a < static_cast<Index>(ids.size()); ++a) {
    for (const Index id : neighbours.of(ids[a], std::min(path_k, neighbours.k))) {
      const Index b = position(id);
      if (b == none) continue;
      const double length = distance(points[ids[a]], points[id]);
      // A score of exactly 0 (p = 1) must not make a join free or infinitely dear.
      const double scored = std::max(1e-6, scores.log_score[ids[a]] + scores.log_score[id]);
      band.joins.push_back({std::min(a, b), std::max(a, b), length, length * length / scored});
    }
  }
  const auto ends = [](const Join& j) { return std::tie(j.a, j.b); };
  std::sort(band.joins.begin(), band.joins.end(),
            [&](const Join& x, const Join& y) { return ends(x) < ends(y); });
  band.joins.erase(std::unique(band.joins.begin(), band.joins.end(),
                               [&](const Join& x, const Join& y) { return ends(x) == ends(y); }),
                   band.joins.end());
  band.joins_of.resize(ids.size());
  for (Index j = 0; j < static_cast<Index>(band.joins.size()); ++j) {
    band.joins_of[band.joins[j].a].push_back(j);
    band.joins_of[band.joins[j].b].push_back(j);
  }
  return band;
}

// Cheapest paths from the root: parent of each point, points in the path, its length and its cost.
struct Tree {
  std::vector<Index> parent, depth;
  std::vector<double> length, cost;
};

Tree cheapest_paths(const Band& band, Index root) {
  const std::size_t count = band.joins_of.size();
  Tree tree{std::vector<Index>(count, none), std::vector<Index>(count, 0), std::vector<double>(count, 0),
            std::vector<double>(count, std::numeric_limits<double>::infinity())};
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  tree.cost[root] = 0;
  open.emplace(0, root);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > tree.cost[at]) continue;
    for (const Index j : band.joins_of[at]) {
      const Join& join = band.joins[j];
      const Index to = join.a == at ? join.b : join.a;
      if (cost + join.cost >= tree.cost[to]) continue;
      tree.cost[to] = cost + join.cost;
      tree.length[to] = tree.length[at] + join.length;
      tree.depth[to] = tree.depth[at] + 1;
      tree.parent[to] = at;
      open.emplace(tree.cost[to], to);
    }
  }
  return tree;
}

Index common_ancestor(const Tree& tree, Index a, Index b) {
  while (a != b) {
    if (tree.depth[a] < tree.depth[b]) std::swap(a, b);
    a = tree.parent[a];
  }
  return a;
}

std::vector<Index> tree_cycle(const Tree& tree, const Join& join, std::span<const Index> ids) {
  const Index top = common_ancestor(tree, join.a, join.b);
  std::vector<Index> up, down;
  for (Index p = join.a; p != top; p = tree.parent[p]) up.push_back(ids[p]);
  for (Index p = join.b; p != top; p = tree.parent[p]) down.push_back(ids[p]);
  up.push_back(ids[top]);
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

Index highest_score(const BoundaryScores& scores, std::span<const Index> ids) {
  Index best = 0;
  for (Index i = 1; i < static_cast<Index>(ids.size()); ++i) {
    if (scores.log_score[ids[i]] > scores.log_score[ids[best]]) best = i;
  }
  return best;
}

}  // namespace

std::vector<Index> order_loop(Points points, const Neighbours& neighbours, int path_k,
                              const BoundaryScores& scores, std::span<const Index> ids) {
  if (ids.size() < 3) return {};
  const Band band = make_band(points, neighbours, path_k, scores, ids);
  const Tree tree = cheapest_paths(band, highest_score(scores, ids));

  struct Cycle {
    Index join;
    double length, cost;
  };
  std::vector<Cycle> cycles;
  double longest = 0;
  for (Index j = 0; j < static_cast<Index>(band.joins.size()); ++j) {
    const auto& [a, b, length, cost] = band.joins[j];
    if (tree.parent[a] == b || tree.parent[b] == a) continue;
    const double infinity = std::numeric_limits<double>::infinity();
    if (tree.cost[a] == infinity || tree.cost[b] == infinity) continue;
    const Index top = common_ancestor(tree, a, b);
    cycles.push_back({j, tree.length[a] + tree.length[b] - 2 * tree.length[top] + length,
                      tree.cost[a] + tree.cost[b] - 2 * tree.cost[top] + cost});
    longest = std::max(longest, cycles.back().length);
  }
  const Cycle* best = nullptr;
  for (const Cycle& cycle : cycles) {
    if (cycle.length < longest / 2) continue;
    if (best == nullptr || cycle.cost < best->cost) best = &cycle;
  }
  return best == nullptr ? std::vector<Index>{} : tree_cycle(tree, band.joins[best->join], ids);
}

}  // namespace rimline
