// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "boundary/simple.h"
#include "random.h"

namespace rimline {
namespace {

std::vector<int> count(const std::vector<UV>& image, int sectors) {
  std::vector<double> u, v;
  for (const UV& p : image) u.push_back(p.u), v.push_back(p.v);
  std::vector<int> counts(sectors);
  Sectors(sectors).count(u, v, counts);
  return counts;
}

TEST_CASE("hand-counted sectors: two points in the first of four, one in each other") {
  CHECK(count({{1, 0}, {2, 1}, {-1, 3}, {-2, -1}, {0.5, -0.1}}, 4) == std::vector<int>{2, 1, 1, 1});
}

TEST_CASE("a sector holds its first edge and not its last") {
  CHECK(count({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 4) == std::vector<int>{1, 1, 1, 1});
  CHECK(count({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}, 8) ==
        std::vector<int>{1, 1, 1, 1, 1, 1, 1, 1});
}

TEST_CASE("an angle just below zero belongs to the last sector") {
  CHECK(count({{1, -1e-300}}, 8) == std::vector<int>{0, 0, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("a point on the centre counts as angle 0, and no number somewhere") {
  CHECK(count({{0, 0}, {-0.0, -0.0}}, 3) == std::vector<int>{2, 0, 0});
  CHECK(count({{std::nan(""), 1}}, 3)[2] == 1);
}

TEST_CASE("sectors of random points of any length are those of the arctangent, for any number of sectors") {
  Random random(6);
  for (int sectors = 2; sectors <= 360; ++sectors) {
    const Sectors fast(sectors);
    for (int i = 0; i < 300; ++i) {
      const double length = std::exp(200 * random.uniform() - 100);
      const UV p{length * (random.uniform() - 0.5), length * (random.uniform() - 0.5)};
      std::vector<int> counts;
      simple::count_sectors(std::vector<UV>{p}, sectors, counts);
      CHECK(counts[fast.of(p.u, p.v)] == 1);
    }
  }
}

TEST_CASE("sectors change within rounding of their edges") {
  for (int sectors = 2; sectors <= 360; ++sectors) {
    const Sectors fast(sectors);
    for (int s = 0; s < sectors; ++s) {
      const double edge = 2 * std::numbers::pi * s / sectors;
      CHECK(fast.of(std::cos(edge + 1e-14), std::sin(edge + 1e-14)) == s);
      CHECK(fast.of(std::cos(edge - 1e-14), std::sin(edge - 1e-14)) == (s + sectors - 1) % sectors);
    }
  }
}

TEST_CASE("the statistic of eq. (1) by hand: 40 angles over 8 sectors, all on one half") {
  // expected 5 each; four sectors are 10, four are 0: 8 * 25 / 5
  CHECK(pearson_statistic(std::vector<int>{10, 10, 10, 10, 0, 0, 0, 0}) == doctest::Approx(40));
  CHECK(pearson_statistic(std::vector<int>{5, 5, 5, 5, 5, 5, 5, 5}) == doctest::Approx(0));
}

}  // namespace
}  // namespace rimline
