// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/complex.h"

#include <doctest/doctest.h>

#include "exact/rim.h"

using namespace rimline;
using namespace rimline::exact;

namespace {

// A wheel: a hub, and six points around it.
const std::vector<Point> wheel{{0, 0, 0},  {1, 0, 0},        {0.5, 0.87, 0}, {-0.5, 0.87, 0},
                               {-1, 0, 0}, {-0.5, -0.87, 0}, {0.5, -0.87, 0}};
const std::vector<Frame> flat(7, Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0});

}  // namespace

TEST_CASE("a wheel closes, its rim is the six points around the hub") {
  Complex complex(wheel, flat);
  for (Index i = 1; i <= 6; ++i) {
    const Triangle t{0, i, i % 6 + 1};
    REQUIRE(complex.can_add(t));
    complex.add(t);
  }
  const auto loops = walk_rims(complex, Kept(6, 1));
  REQUIRE(loops.size() == 1);
  CHECK(loops[0] == std::vector<Index>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("leaving triangles out keeps the rim closed, and a pinch splits it") {
  Complex complex(wheel, flat);
  for (Index i = 1; i <= 6; ++i) complex.add({0, i, i % 6 + 1});
  CHECK(walk_rims(complex, {0, 1, 1, 1, 1, 1}) == std::vector<std::vector<Index>>{{0, 2, 3, 4, 5, 6, 1}});
  CHECK(walk_rims(complex, {0, 1, 1, 0, 1, 1}).size() == 2);
}

TEST_CASE("a triangle that crosses others, or gives an edge a third triangle, can not be added") {
  Complex complex(wheel, flat);
  complex.add({0, 1, 2});
  complex.add({0, 2, 3});
  CHECK_FALSE(complex.can_add({0, 1, 3}));  // over both
  CHECK_FALSE(complex.can_add({0, 2, 4}));  // a third at edge 0-2
  CHECK(complex.can_add({0, 3, 4}));
}

TEST_CASE("a triangle that folds back over its neighbour can not be added") {
  std::vector<Point> points = wheel;
  points[3] = {0.5, 0.2, 0.1};  // almost over the triangle 0-1-2
  Complex complex(points, flat);
  complex.add({0, 1, 2});
  CHECK_FALSE(complex.can_add({0, 1, 3}));
}
