// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "measure/triangles_meet.h"
#include "random.h"
#include "rimline/measure.h"
#include "shapes.h"

namespace rimline {

TEST_CASE("the pairs found are those that exact predicates find among all pairs") {
  Random random(11);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) points.push_back({random.uniform(), random.uniform(), random.uniform()});
    std::vector<Triangle> triangles;
    while (triangles.size() < 80) {
      const auto any = [&] { return static_cast<Index>(random.uniform() * 60); };
      const Triangle t{any(), any(), any()};
      if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triangles.push_back(t);
    }
    std::vector<std::array<Index, 2>> all;
    for (Index i = 0; i < 80; ++i) {
      for (Index j = i + 1; j < 80; ++j) {
        if (triangles_meet(points, triangles[i], triangles[j])) all.push_back({i, j});
      }
    }
    CHECK(!all.empty());
    CHECK(find_self_intersections(points, triangles, {}) == all);
  }
}

TEST_CASE("neighbours in a mesh do not count as meeting, but a fold flat over its edge does") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.9, 0.9, 0}};
  CHECK(find_self_intersections(points, {{0, 1, 2}, {1, 3, 2}}, {}).empty());
  CHECK(find_self_intersections(points, {{1, 3, 2}, {2, 4, 1}}, {}).size() == 1);
}

TEST_CASE("a triangle through another is found, and one that only comes close is not") {
  const std::vector<Point> points = {{0, 0, 0},      {1, 0, 0},     {0, 1, 0},        {0.2, 0.2, -1},
                                     {0.3, 0.2, -1}, {0.2, 0.3, 1}, {0.2, 0.3, -1e-9}};
  CHECK(find_self_intersections(points, {{0, 1, 2}, {3, 4, 5}}, {}).size() == 1);
  CHECK(find_self_intersections(points, {{0, 1, 2}, {3, 4, 6}}, {}).empty());
}

}  // namespace rimline
