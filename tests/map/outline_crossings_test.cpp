// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/outline_crossings.h"

#include <doctest/doctest.h>

namespace rimline {
namespace {

Loop loop_of(std::vector<Index> points) {
  Loop loop;
  loop.points = std::move(points);
  return loop;
}

}  // namespace

TEST_CASE("the points of edges that cross are told, those of neighbours that share an end are not") {
  const std::vector<UV> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(crossing_points({loop_of({0, 1, 2, 3})}, square).empty());
  CHECK(crossing_points({loop_of({0, 2, 1, 3})}, square) == std::vector<Index>{0, 1, 2, 3});  // an hourglass
}

TEST_CASE("a hole that reaches over the outline crosses it, one inside does not") {
  std::vector<UV> uv{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 1}};
  const std::vector<Loop> loops{loop_of({0, 1, 2, 3}), loop_of({4, 5, 6})};
  CHECK(crossing_points(loops, uv).empty());
  uv[6] = {5, 1};
  CHECK(crossing_points(loops, uv) == std::vector<Index>{1, 2, 4, 5, 6});
  uv[6] = {4, 1};  // touching counts
  CHECK_FALSE(crossing_points(loops, uv).empty());
}

}  // namespace rimline
