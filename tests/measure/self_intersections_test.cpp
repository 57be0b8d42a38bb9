// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "base/random.h"
#include "measure/triangles_meet.h"
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

namespace {

std::vector<std::array<Index, 2>> among_all_pairs(Points points, const std::vector<Triangle>& triangles) {
  std::vector<std::array<Index, 2>> all;
  for (Index i = 0; i < static_cast<Index>(triangles.size()); ++i) {
    for (Index j = i + 1; j < static_cast<Index>(triangles.size()); ++j) {
      if (triangles_meet(points, triangles[i], triangles[j])) all.push_back({i, j});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("meshes from smooth to crumpled have the pairs that are found among all pairs") {
  constexpr int side = 12;
  Random random(3);
  for (const double crumpled : {0.0, 0.2, 0.5, 0.8, 1.5}) {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    for (int i = 0; i < side * side; ++i) {
      const auto off = [&] { return crumpled * (random.uniform() - 0.5); };
      const double x = i % side, y = i / side;
      points.push_back({x + off(), y + off(), 0.1 * x * x + off()});
    }
    for (Index y = 0; y + 1 < side; ++y) {
      for (Index x = 0; x + 1 < side; ++x) {
        const Index a = y * side + x, b = a + 1, c = a + side, d = c + 1;
        triangles.push_back({a, b, d});
        triangles.push_back({a, d, c});
      }
    }
    const auto all = among_all_pairs(points, triangles);
    if (crumpled == 0) CHECK(all.empty());
    if (crumpled == 1.5) CHECK(all.size() > 3);
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
