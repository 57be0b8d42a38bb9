// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/band.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace rimline {

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
      // A score of exactly 0 (p = 1) must not make the cost of an edge zero or infinite.
      const double scored = std::max(1e-6, scores.log_score[ids[a]] + scores.log_score[id]);
      band.joins.push_back({std::min(a, b), std::max(a, b), length, length * length * length / scored});
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

namespace {

// Dijkstra 1959 from one root.
void grow(const Band& band, Index root, std::vector<char>& settled, Forest& forest) {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  forest.cost[root] = 0;
  open.emplace(0, root);
  while (!open.empty()) {
    const Index at = open.top().second;
    open.pop();
    if (settled[at] != 0) continue;
    settled[at] = 1;
    forest.order.push_back(at);
    for (const Index j : band.joins_of[at]) {
      const Join& join = band.joins[j];
      const Index to = band.other_end(j, at);
      const double cost = forest.cost[at] + join.cost;
      if (settled[to] != 0 || cost >= forest.cost[to]) continue;
      forest.cost[to] = cost;
      forest.length[to] = forest.length[at] + join.length;
      forest.depth[to] = forest.depth[at] + 1;
      forest.parent[to] = at;
      open.emplace(cost, to);
    }
  }
}

}  // namespace

Forest cheapest_ways(const Band& band, std::span<const Index> by_rank) {
  const std::size_t count = band.joins_of.size();
  Forest forest{std::vector<Index>(count, none),
                std::vector<Index>(count, 0),
                std::vector<double>(count, 0),
                std::vector<double>(count, std::numeric_limits<double>::infinity()),
                {}};
  std::vector<char> settled(count, 0);
  for (const Index root : by_rank) {
    if (settled[root] == 0) grow(band, root, settled, forest);
  }
  return forest;
}

namespace {

// A class of cycles: the generators whose sum it is, ascending.
using Class = std::vector<Index>;

Class sum(const Class& a, const Class& b) {
  Class result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

// Gives each join the class of the cycle that it closes, while points come in one by one: a point brings a
// generator for every further piece of what it is joined to, and each triangle a relation.
class CycleClasses {
 public:
  CycleClasses(const Band& band, const Forest& forest)
      : band_(band),
        class_(band.joins.size()),
        there_(band.joins.size(), 0),
        join_to_(band.joins_of.size(), none),
        reached_(band.joins_of.size(), 0) {
    std::vector<char> in(band.joins_of.size(), 0);
    for (const Index v : forest.order) {
      add(v, forest.parent[v], in);
      in[v] = 1;
    }
  }

  bool is_zero(Index join) const { return class_[join].empty(); }

 private:
  void add(Index v, Index parent, const std::vector<char>& in) {
    std::vector<Index> near;
    for (const Index j : band_.joins_of[v]) {
      const Index u = band_.other_end(j, v);
      if (in[u] == 0) continue;
      join_to_[u] = j;
      near.push_back(u);
    }
    if (parent != none) flood(parent, {});
    for (const Index u : near) {
      if (reached_[u] == 0) flood(u, {generators_++});
    }
    for (const Index u : near) {
      there_[join_to_[u]] = 1;
      join_to_[u] = none;
      reached_[u] = 0;
    }
  }

  // The piece of the link of a point that `from` lies in, whose join to the point has the class `first`.
  void flood(Index from, const Class& first) {
    class_[join_to_[from]] = first;
    reached_[from] = 1;
    std::vector<Index> open{from};
    while (!open.empty()) {
      const Index u = open.back();
      open.pop_back();
      for (const Index j : band_.joins_of[u]) {
        const Index w = band_.other_end(j, u);
        if (there_[j] == 0 || join_to_[w] == none) continue;
        const Class by_triangle = sum(class_[join_to_[u]], class_[j]);
        if (reached_[w] != 0) {
          vanish(sum(by_triangle, class_[join_to_[w]]));
          continue;
        }
        class_[join_to_[w]] = by_triangle;
        reached_[w] = 1;
        open.push_back(w);
      }
    }
  }

  // The class of a triangle is zero: one of its generators is the sum of the others.
  void vanish(const Class& relation) {
    if (relation.empty()) return;
    for (Class& c : class_) {
      if (std::binary_search(c.begin(), c.end(), relation.back())) c = sum(c, relation);
    }
  }

  const Band& band_;
  std::vector<Class> class_;    // of each join
  std::vector<char> there_;     // both ends of the join are in
  std::vector<Index> join_to_;  // from the point that comes in; `none` where there is none
  std::vector<char> reached_;   // by the flood about it
  Index generators_ = 0;
};

}  // namespace

std::vector<std::uint8_t> going_round(const Band& band, const Forest& forest) {
  const CycleClasses classes(band, forest);
  std::vector<std::uint8_t> round(band.joins.size());
  for (Index j = 0; j < static_cast<Index>(round.size()); ++j) round[j] = !classes.is_zero(j);
  return round;
}

}  // namespace rimline
