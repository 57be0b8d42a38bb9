// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_set.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "surface/rims.h"

using namespace rimline;

namespace {

// A wheel: a hub, and six points around it.
const std::vector<Point> wheel{{0, 0, 0},  {1, 0, 0},        {0.5, 0.87, 0}, {-0.5, 0.87, 0},
                               {-1, 0, 0}, {-0.5, -0.87, 0}, {0.5, -0.87, 0}};
const std::vector<Frame> flat(7, Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0});

}  // namespace

TEST_CASE("a wheel closes, its rim is the six points around the hub") {
  TriangleSet set(wheel, flat);
  for (Index i = 1; i <= 6; ++i) {
    const Triangle t{0, i, i % 6 + 1};
    REQUIRE(set.can_add(t));
    set.add(t);
  }
  const auto loops = walk_rims(set, Selection(6, 1));
  REQUIRE(loops.size() == 1);
  CHECK(loops[0] == std::vector<Index>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("leaving triangles out keeps the rim closed, and a pinch splits it") {
  TriangleSet set(wheel, flat);
  for (Index i = 1; i <= 6; ++i) set.add({0, i, i % 6 + 1});
  CHECK(walk_rims(set, {0, 1, 1, 1, 1, 1}) == std::vector<std::vector<Index>>{{0, 2, 3, 4, 5, 6, 1}});
  CHECK(walk_rims(set, {0, 1, 1, 0, 1, 1}).size() == 2);
}

TEST_CASE("a triangle that crosses others, or gives an edge a third triangle, can not be added") {
  TriangleSet set(wheel, flat);
  set.add({0, 1, 2});
  set.add({0, 2, 3});
  CHECK_FALSE(set.can_add({0, 1, 3}));  // over both
  CHECK_FALSE(set.can_add({0, 2, 4}));  // a third at edge 0-2
  CHECK(set.can_add({0, 3, 4}));
}

TEST_CASE("a triangle that folds back over its neighbour can not be added") {
  std::vector<Point> points = wheel;
  points[3] = {0.5, 0.2, 0.1};  // almost over the triangle 0-1-2
  TriangleSet set(points, flat);
  set.add({0, 1, 2});
  CHECK_FALSE(set.can_add({0, 1, 3}));
}

TEST_CASE(
    "what is across an edge is what a look at all triangles finds, after adding, leaving out and turning") {
  std::vector<Point> points;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) points.push_back({double(x), double(y), 0});
  }
  const std::vector<Frame> frames(points.size(), Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0});
  TriangleSet set(points, frames);
  const auto check = [&] {
    for (Index t = 0; t < set.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index a = set.triangle(t)[i], b = set.triangle(t)[(i + 1) % 3];
        Index other = none;
        for (Index s = 0; s < set.size(); ++s) {
          const auto& x = set.triangle(s);
          if (s != t && std::count(x.begin(), x.end(), a) && std::count(x.begin(), x.end(), b)) other = s;
        }
        REQUIRE(set.across(t, i) == other);
        REQUIRE(set.across(t, a, b) == other);
        REQUIRE(set.across(t, b, a) == other);
        REQUIRE(set.apex(t, a, b) == set.triangle(t)[(i + 2) % 3]);
      }
    }
  };
  for (Index y = 0; y < 11; ++y) {
    for (Index x = 0; x < 11; ++x) {
      const Index a = 12 * y + x;
      set.add({a, a + 1, a + 12});
      set.add({a + 13, a + 12, a + 1});
    }
  }
  check();
  Selection kept(set.size(), 1);
  for (Index t = 0; t < set.size(); t += 5) kept[t] = 0;
  const Triangle gone = set.triangle(0);
  set.keep_only(kept);
  check();
  set.add(gone);
  for (Index t = 0; t < set.size(); t += 3) set.flip_if(t, true);
  check();
}
