// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "boundary/simple.h"

namespace rimline {
namespace {

// In the last lane; all others hold points elsewhere.
std::vector<int> count(const std::vector<UV>& image, const Sectors& sectors, int number) {
  std::vector<Lanes> u(image.size(), Lanes{{3, 3, 3, 3, 3, 3, 3, 3}}), v(u);
  for (std::size_t j = 0; j < image.size(); ++j) {
    u[j][lanes - 1] = image[j].u;
    v[j][lanes - 1] = image[j].v;
  }
  std::vector<Lanes> counts(number);
  sectors.count(u, v, counts);
  std::vector<int> last;
  for (const Lanes& c : counts) last.push_back(static_cast<int>(c[lanes - 1]));
  return last;
}

std::vector<int> count(const std::vector<UV>& image, int number) {
  return count(image, Sectors(number), number);
}

// The one that holds the point.
int sector_of(UV point, const Sectors& sectors, int number) {
  const auto counts = count({point}, sectors, number);
  const auto found = std::find(counts.begin(), counts.end(), 1);
  const auto zeros = std::count(counts.begin(), counts.end(), 0);
  return zeros == number - 1 && found != counts.end() ? static_cast<int>(found - counts.begin()) : -1;
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
  for (const int sectors : {2, 3, 8}) {
    CHECK(count({{0, 0}, {-0.0, -0.0}, {0, -0.0}, {-0.0, 0}}, sectors)[0] == 4);
    CHECK(count({{std::nan(""), 1}, {1, std::nan("")}}, sectors)[0] == 2);
  }
}

TEST_CASE("sectors of random points of any length are those of the arctangent, for any number of sectors") {
  Random random(6);
  for (int sectors = 2; sectors <= 360; ++sectors) {
    std::vector<UV> points;
    for (int i = 0; i < 300; ++i) {
      const double length = std::exp(200 * random.uniform() - 100);
      points.push_back({length * (random.uniform() - 0.5), length * (random.uniform() - 0.5)});
    }
    std::vector<int> counts;
    simple::count_sectors(points, sectors, counts);
    CHECK(count(points, sectors) == counts);
  }
}

TEST_CASE("every lane is counted as a point alone is, on edges, axes and the origin too") {
  Random random(7);
  for (const int sectors : {2, 3, 7, 8, 64}) {
    const Sectors fast(sectors);
    std::vector<Lanes> u(60), v(60), counts(sectors), expected(sectors, Lanes{});
    for (std::size_t j = 0; j < u.size(); ++j) {
      for (int l = 0; l < lanes; ++l) {
        const auto number = [&] {
          return j % 2 ? static_cast<double>(random.below(7)) - 3 : random.uniform() - 0.5;
        };
        u[j][l] = number();
        v[j][l] = number();
        ++expected[sector_of({u[j][l], v[j][l]}, fast, sectors)][l];
      }
    }
    fast.count(u, v, counts);
    for (int s = 0; s < sectors; ++s) {
      for (int l = 0; l < lanes; ++l) CHECK(counts[s][l] == expected[s][l]);
    }
  }
}

TEST_CASE("points of whole numbers are in the eighth of the turn that their signs and sizes tell") {
  const Sectors eighths(8);
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) {
      if (x == 0 && y == 0) continue;
      const bool lower = y < 0 || (y == 0 && x < 0);
      const int a = lower ? -x : x, b = lower ? -y : y;  // turned by half where below
      const int eighth = a > b ? 0 : a > 0 ? 1 : -a < b ? 2 : 3;
      CHECK(sector_of({0.1 * x, 0.1 * y}, eighths, 8) == eighth + 4 * lower);
    }
  }
}

TEST_CASE("sectors change within rounding of their edges") {
  for (int sectors = 2; sectors <= 360; ++sectors) {
    const Sectors fast(sectors);
    for (int s = 0; s < sectors; ++s) {
      const double edge = 2 * std::numbers::pi * s / sectors;
      CHECK(sector_of({std::cos(edge + 1e-14), std::sin(edge + 1e-14)}, fast, sectors) == s);
      CHECK(sector_of({std::cos(edge - 1e-14), std::sin(edge - 1e-14)}, fast, sectors) ==
            (s + sectors - 1) % sectors);
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
