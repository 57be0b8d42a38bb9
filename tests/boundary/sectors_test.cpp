// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace rimline {
namespace {

TEST_CASE("hand-counted sectors: two points in the first of four, one in each other") {
  std::vector<int> counts;
  count_sectors(std::vector<UV>{{1, 0}, {2, 1}, {-1, 3}, {-2, -1}, {0.5, -0.1}}, 4, counts);
  CHECK(counts == std::vector<int>{2, 1, 1, 1});
}

TEST_CASE("a sector holds its first edge and not its last") {
  std::vector<int> counts;
  count_sectors(std::vector<UV>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 4, counts);
  CHECK(counts == std::vector<int>{1, 1, 1, 1});
}

TEST_CASE("an angle just below zero belongs to the last sector") {
  std::vector<int> counts;
  count_sectors(std::vector<UV>{{1, -1e-300}}, 8, counts);
  CHECK(counts == std::vector<int>{0, 0, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("a point on the centre counts as angle 0") {
  std::vector<int> counts;
  count_sectors(std::vector<UV>{{0, 0}}, 3, counts);
  CHECK(counts == std::vector<int>{1, 0, 0});
}

TEST_CASE("the statistic of eq. (1) by hand: 40 angles over 8 sectors, all on one half") {
  // expected 5 each; four sectors are 10, four are 0: 8 * 25 / 5
  CHECK(pearson_statistic(std::vector<int>{10, 10, 10, 10, 0, 0, 0, 0}) == doctest::Approx(40));
  CHECK(pearson_statistic(std::vector<int>{5, 5, 5, 5, 5, 5, 5, 5}) == doctest::Approx(0));
}

}  // namespace
}  // namespace rimline
