// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/close_ring.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "shapes.h"

namespace rimline {
namespace {

double area(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * norm(cross(points[b] - points[a], points[c] - points[a]));
  return sum;
}

bool free_edge(Index, Index) { return false; }

TEST_CASE("a ring with a bay is closed with the area of its polygon, each side once and in its direction") {
  std::vector<Point> points{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0},
                            {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};  // a U of area 8
  points = shapes::turned(points, 0.3, 0.5, 0.7);
  std::vector<Index> ring(points.size());
  std::iota(ring.begin(), ring.end(), Index{0});
  const auto triangles = close_ring(points, ring, free_edge);
  REQUIRE(triangles.size() == 6);
  CHECK(area(points, triangles) == doctest::Approx(8));
  for (const Index v : ring) {
    const Index w = (v + 1) % 8;
    CHECK(std::ranges::count_if(triangles, [&](const Triangle& t) {
            return (t[0] == v && t[1] == w) || (t[1] == v && t[2] == w) || (t[2] == v && t[0] == w);
          }) == 1);
  }
}

TEST_CASE("an edge that is taken is not made again, and where every way needs one nothing is returned") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1.1, 1.1, 0}, {0, 1, 0}};
  const std::vector<Index> ring{0, 1, 2, 3};
  const auto joins = [](Index a, Index b, Index c, Index d) {
    return std::minmax(a, b) == std::minmax(c, d);
  };
  const auto triangles = close_ring(points, ring, [&](Index a, Index b) { return joins(a, b, 1, 3); });
  REQUIRE(triangles.size() == 2);
  for (const Triangle& t : triangles) CHECK(std::ranges::count(t, 0) + std::ranges::count(t, 2) == 2);
  CHECK(close_ring(points, ring, [](Index, Index) { return true; }).empty());
}

}  // namespace
}  // namespace rimline
