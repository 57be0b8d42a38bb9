// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/polygon.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "base/random.h"

namespace rimline {
namespace {

bool any_pair(Index, Index) { return true; }

double area_of(Points points, const Triangle& t) {
  return 0.5 * norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
}

double area_of(Points points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += area_of(points, t);
  return sum;
}

// n - 2 triangles that have each side of the polygon once, in its direction, and all other edges twice.
void check_fills(std::size_t corners, const std::vector<Triangle>& triangles) {
  CHECK(triangles.size() == corners - 2);
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) ++edges[{t[c], t[(c + 1) % 3]}];
  }
  const auto n = static_cast<Index>(corners);
  for (const auto& [edge, times] : edges) {
    const bool is_side = (edge.first + 1) % n == edge.second;
    const bool has_other = edges.contains({edge.second, edge.first});
    REQUIRE(times == 1);
    REQUIRE(has_other != is_side);
  }
}

// The least area of all triangulations of the corners from `first` to `last`.
double least_area(Points points, std::size_t first, std::size_t last) {
  if (last < first + 2) return 0;
  double least = 1e300;
  for (std::size_t k = first + 1; k < last; ++k) {
    const Triangle t{static_cast<Index>(first), static_cast<Index>(k), static_cast<Index>(last)};
    least = std::min(least, area_of(points, t) + least_area(points, first, k) + least_area(points, k, last));
  }
  return least;
}

std::vector<Point> wavy_ring(int corners, double wave) {
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = 1 + 0.3 * std::sin(7 * angle);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), wave * std::cos(3 * angle)});
  }
  return points;
}

}  // namespace

TEST_CASE("a flat polygon that is not convex is filled with its own area") {
  const std::vector<Point> corners = {{0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};
  const auto triangles = triangulate_polygon(corners, any_pair);
  check_fills(corners.size(), triangles);
  CHECK(area_of(corners, triangles) == doctest::Approx(5));
}

TEST_CASE("no triangulation of a small polygon in space has less area") {
  Random random(4);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({random.uniform(), random.uniform(), random.uniform()});
    const auto triangles = triangulate_polygon(corners, any_pair);
    check_fills(corners.size(), triangles);
    // The share that prefers compact triangles may cost a little area.
    CHECK(area_of(corners, triangles) <= least_area(corners, 0, 7) * 1.02);
  }
}

TEST_CASE("corners that may not be joined are not, and a polygon that can not do without is left") {
  const std::vector<Point> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const auto& t : triangulate_polygon(square, [](Index a, Index b) { return a + b != 2; }))
    CHECK((t == Triangle{0, 1, 3} || t == Triangle{1, 2, 3}));
  CHECK(triangulate_polygon(square, [](Index, Index) { return false; }).empty());
}

TEST_CASE("ten thousand corners are filled, flat or not") {
  for (const double wave : {0.0, 0.2, 5.0}) {
    const auto corners = wavy_ring(10'000, wave);
    check_fills(corners.size(), triangulate_polygon(corners, any_pair));
  }
}

TEST_CASE("a large polygon that crosses itself when laid flat is filled nonetheless") {
  std::vector<Point> corners;  // a ring that winds twice
  for (int i = 0; i < 1000; ++i) {
    const double angle = 4 * std::numbers::pi * i / 1000;
    const double radius = 1 + 0.3 * std::cos(angle / 2);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), std::sin(angle / 2)});
  }
  check_fills(corners.size(), triangulate_polygon(corners, any_pair));
}

}  // namespace rimline
