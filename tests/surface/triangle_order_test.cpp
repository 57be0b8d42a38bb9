// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_order.h"

#include <doctest/doctest.h>

#include <array>
#include <numeric>
#include <vector>

#include "base/random.h"

using namespace rimline;

namespace {

// Where the corners of triangles are, in the order that settles ties between them.
std::vector<std::array<double, 3>> ordered(const std::vector<Point>& points,
                                           std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end(), TriangleOrder(points));
  std::vector<std::array<double, 3>> places;
  for (const Triangle& t : triangles) {
    Point sum;
    for (const Index v : t) sum = sum + points[v];
    places.push_back({sum.x, sum.y, sum.z});
  }
  return places;
}

}  // namespace

TEST_CASE("the order of triangles is one of places: not of how points, corners and triangles are numbered") {
  Random random(9);
  std::vector<Point> points;  // of a grid: many coordinates are equal
  for (int i = 0; i < 60; ++i) points.push_back({double(i % 6), double(i / 6), 0});
  std::vector<Triangle> triangles;
  for (Index i = 0; i + 7 < 60; ++i) triangles.push_back({i, i + 1, i + 7});
  const auto before = ordered(points, triangles);

  std::vector<Index> number(points.size());
  std::iota(number.begin(), number.end(), Index{0});
  random.shuffle(number);
  std::vector<Point> moved(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) moved[number[i]] = points[i];
  for (Triangle& t : triangles) t = {number[t[2]], number[t[0]], number[t[1]]};
  random.shuffle(triangles);
  CHECK(ordered(moved, triangles) == before);
}

TEST_CASE("triangles in one place are told apart by their ids") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  const TriangleOrder is_before(points);
  CHECK(is_before({0, 1, 2}, {3, 1, 2}));
  CHECK_FALSE(is_before({3, 1, 2}, {0, 1, 2}));
  CHECK_FALSE(is_before({0, 1, 2}, {0, 1, 2}));
}
