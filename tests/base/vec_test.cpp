// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/vec.h"

#include <doctest/doctest.h>

#include <vector>

namespace rimline {
namespace {

TEST_CASE("the last of a ring is followed by its first, all others by the next") {
  CHECK(next_in(0, 3) == 1);
  CHECK(next_in(1, 3) == 2);
  CHECK(next_in(2, 3) == 0);
  CHECK(next_in(std::size_t{0}, std::vector<int>(1).size()) == 0);
}

TEST_CASE("the normal of a right triangle stands on it, as long as twice its area, by the right hand") {
  const std::vector<Point> points{{1, 1, 5}, {4, 1, 5}, {1, 3, 5}};
  const Point normal = triangle_normal(points, {0, 1, 2});
  CHECK(normal.x == 0);
  CHECK(normal.y == 0);
  CHECK(normal.z == 6);
  CHECK(triangle_normal(points, {0, 2, 1}).z == -6);
  CHECK(triangle_area(points, {0, 2, 1}) == 3);
}

}  // namespace
}  // namespace rimline
