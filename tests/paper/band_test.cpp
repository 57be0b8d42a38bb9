// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/band.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <numbers>

#include "base/random.h"

namespace rimline {
namespace {

constexpr std::size_t most_joins = 128;
using Chain = std::bitset<most_joins>;  // a sum of joins over GF(2)

// The span of some chains, brought to echelon form.
class Span {
 public:
  // Returns whether the chain was new to it.
  bool add(Chain chain) {
    for (std::size_t bit = 0; bit < most_joins; ++bit) {
      if (!chain[bit]) continue;
      if (pivots_[bit].none()) {
        pivots_[bit] = chain;
        return true;
      }
      chain ^= pivots_[bit];
    }
    return false;
  }

 private:
  std::array<Chain, most_joins> pivots_;
};

// The band of points that are joined where they are less than `reach` apart.
struct Example {
  std::vector<Point> points;
  Band band;
  Forest forest;
};

Example joined(std::vector<Point> points, double reach) {
  Example e{std::move(points), {}, {}};
  const auto count = static_cast<Index>(e.points.size());
  e.band.joins_of.resize(count);
  std::vector<Index> all;
  for (Index a = 0; a < count; ++a) {
    all.push_back(a);
    for (Index b = a + 1; b < count; ++b) {
      const double length = distance(e.points[a], e.points[b]);
      if (length >= reach) continue;
      const auto j = static_cast<Index>(e.band.joins.size());
      e.band.joins.push_back({a, b, length, length});
      e.band.joins_of[a].push_back(j);
      e.band.joins_of[b].push_back(j);
    }
  }
  e.forest = cheapest_ways(e.band, all);
  return e;
}

Index join_between(const Band& band, Index a, Index b) {
  for (const Index j : band.joins_of[a]) {
    if (band.other_end(j, a) == b) return j;
  }
  return none;
}

Span triangles_of(const Band& band) {
  Span span;
  const auto count = static_cast<Index>(band.joins_of.size());
  for (Index a = 0; a < count; ++a) {
    for (Index b = a + 1; b < count; ++b) {
      for (Index c = b + 1; c < count; ++c) {
        const std::array<Index, 3> sides{join_between(band, a, b), join_between(band, b, c),
                                         join_between(band, a, c)};
        if (std::count(sides.begin(), sides.end(), none) > 0) continue;
        Chain chain;
        for (const Index side : sides) chain.flip(side);
        span.add(chain);
      }
    }
  }
  return span;
}

Chain cycle_by(const Example& e, Index join) {
  Chain chain;
  chain.flip(join);
  for (const Index end : {e.band.joins[join].a, e.band.joins[join].b}) {
    for (Index p = end; e.forest.parent[p] != none; p = e.forest.parent[p])
      chain.flip(join_between(e.band, p, e.forest.parent[p]));
  }
  return chain;
}

std::size_t count_round(const Example& e) {
  const auto round = going_round(e.band, e.forest);
  return std::count(round.begin(), round.end(), 1);
}

std::vector<Point> ring(int count, double radius = 1, Point centre = {}) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(centre + Point{radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return points;
}

TEST_CASE("on random graphs a cycle goes round where elimination says that it is no sum of triangles") {
  Random random(11);
  int round = 0, not_round = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Point> points;
    for (int i = 0; i < 14; ++i) points.push_back({random.uniform(), random.uniform(), 0});
    const Example e = joined(points, 0.3 + 0.3 * random.uniform());
    REQUIRE(e.band.joins.size() < most_joins);
    const auto goes_round = going_round(e.band, e.forest);
    for (Index j = 0; j < static_cast<Index>(e.band.joins.size()); ++j) {
      Span triangles = triangles_of(e.band);
      CHECK(triangles.add(cycle_by(e, j)) == (goes_round[j] == 1));
      goes_round[j] == 1 ? ++round : ++not_round;
    }
  }
  CHECK(round > 100);  // the trials must see both
  CHECK(not_round > 100);
}

TEST_CASE("in a ring one cycle goes round, in a broken ring and in a patch none") {
  std::vector<Point> points = ring(40);
  CHECK(count_round(joined(points, 0.2)) == 1);
  points.resize(30);
  CHECK(count_round(joined(points, 0.2)) == 0);
  std::vector<Point> patch;
  for (int i = 0; i < 49; ++i) patch.push_back({1.0 * (i % 7), 1.0 * (i / 7), 0});
  CHECK(count_round(joined(patch, 1.6)) == 0);
}

TEST_CASE("a band with two holes, and two bands apart, have cycles round both") {
  std::vector<Point> eight = ring(30);
  for (const Point& p : ring(30, 1, {2, 0, 0})) eight.push_back(p);
  CHECK(count_round(joined(eight, 0.25)) >= 2);
  std::vector<Point> apart = ring(30);
  for (const Point& p : ring(30, 1, {5, 0, 0})) apart.push_back(p);
  CHECK(count_round(joined(apart, 0.25)) == 2);
}

TEST_CASE("the ways of the forest are the cheapest there are") {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  const Example e = joined(points, 0.35);
  std::vector<double> cost(points.size(), 1e300);  // Bellman and Ford, from the first root
  cost[0] = 0;
  for (std::size_t round = 0; round < points.size(); ++round) {
    for (const Join& join : e.band.joins) {
      cost[join.b] = std::min(cost[join.b], cost[join.a] + join.cost);
      cost[join.a] = std::min(cost[join.a], cost[join.b] + join.cost);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (cost[i] < 1e299) CHECK(e.forest.cost[i] == doctest::Approx(cost[i]));
  }
}

}  // namespace
}  // namespace rimline
