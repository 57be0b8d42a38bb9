// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/map_to_disc.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "paper/reachable.h"
#include "shapes.h"

namespace rimline {
namespace {

// Eq. (4) checked point by point from its definition.
double worst_residual(Points points, const Neighbours& neighbours, int k, const std::vector<Index>& loop,
                      const std::vector<UV>& uv) {
  std::vector<char> on_loop(points.size(), 0);
  for (const Index id : loop) on_loop[id] = 1;
  double worst = 0;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    if (on_loop[i]) continue;
    double sum = 0, u = 0, v = 0;
    for (const Index j : neighbours.of(i, k)) sum += 1 / distance(points[i], points[j]);
    for (const Index j : neighbours.of(i, k)) {
      const double lambda = 1 / distance(points[i], points[j]) / sum;
      u += lambda * uv[j].u;
      v += lambda * uv[j].v;
    }
    worst = std::max({worst, std::abs(uv[i].u - u), std::abs(uv[i].v - v)});
  }
  return worst;
}

TEST_CASE("every interior point is the convex combination of its neighbours that eq. (4) asks for") {
  const auto disc = shapes::disc(15, 0.5);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const DiscMap map = map_to_disc(disc.points, neighbours, disc.rim, {}, {});
  CHECK(worst_residual(disc.points, neighbours, 20, disc.rim, map.uv) < 1e-10);
  CHECK(map.summary.residual <= 1e-10);
  for (const UV& p : map.uv) CHECK(p.u * p.u + p.v * p.v <= 1 + 1e-12);
}

TEST_CASE("arcs on the circle are in proportion to the chords of the loop") {
  const std::vector<Point> points{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  const auto circle = circle_by_chord_length(points, std::vector<Index>{0, 1, 2});
  CHECK(circle[0].u == doctest::Approx(1));
  CHECK(std::atan2(circle[1].v, circle[1].u) == doctest::Approx(2 * std::numbers::pi * 3 / 12));
  CHECK(std::atan2(circle[2].v, circle[2].u) ==
        doctest::Approx(2 * std::numbers::pi * 7 / 12 - 2 * std::numbers::pi));
}

TEST_CASE("points without a chain of neighbours to the loop are named before anything is solved") {
  auto disc = shapes::disc(10);
  const Index first = static_cast<Index>(disc.points.size());
  for (const Point& p : shapes::disc(5).points) disc.points.push_back(p + Point{50, 0, 0});
  const Neighbours neighbours = find_neighbours(disc.points, 12, {});
  std::vector<Index> island;
  for (Index i = first; i < static_cast<Index>(disc.points.size()); ++i) island.push_back(i);
  try {
    map_to_disc(disc.points, neighbours, disc.rim, {}, {});
    FAIL("mapped an island");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::UnreachableInterior);
    CHECK(error.ids() == island);
  }
}

TEST_CASE("a point that only others point to is reachable by its own list") {
  Neighbours chain;  // 0 <- 1 <- 2, and 0's only neighbour is 1
  chain.k = 1;
  chain.ids = {1, 0, 1};
  CHECK(unreachable_points(chain, 1, std::vector<Index>{0}).empty());
  CHECK(unreachable_points(chain, 1, std::vector<Index>{2}) == std::vector<Index>{0, 1});
}

TEST_CASE("turning the points does not change the map of a given loop") {
  const auto disc = shapes::disc(9, 0.4);
  const auto turned = shapes::turned(disc.points, 0.5, -1, 2);
  const DiscMap a = map_to_disc(disc.points, find_neighbours(disc.points, 20, {}), disc.rim, {}, {});
  const DiscMap b = map_to_disc(turned, find_neighbours(turned, 20, {}), disc.rim, {}, {});
  for (std::size_t i = 0; i < turned.size(); ++i) {
    CHECK(a.uv[i].u == doctest::Approx(b.uv[i].u).epsilon(1e-8));
    CHECK(a.uv[i].v == doctest::Approx(b.uv[i].v).epsilon(1e-8));
  }
}

}  // namespace
}  // namespace rimline
