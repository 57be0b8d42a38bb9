// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/jaggedness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace rimline;

namespace {

constexpr std::size_t n = 200;

std::vector<Index> in_a_row(std::size_t count) {
  std::vector<Index> loop(count);
  std::iota(loop.begin(), loop.end(), 0);
  return loop;
}

// A circle of spacing 1 whose odd points from `first` on lie `depth` further in.
std::vector<Point> saw(std::size_t first, double depth) {
  const double radius = n / (2 * std::numbers::pi);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = 2 * std::numbers::pi * static_cast<double>(i) / n;
    const double r = radius - (i >= first && i % 2 == 1 ? depth : 0);
    points.push_back({r * std::cos(at), r * std::sin(at), 0});
  }
  return points;
}

}  // namespace

TEST_CASE("a circle is even, however few points it has, and a saw is jagged") {
  for (const std::size_t few : {8u, 16u, 60u, 200u}) {
    std::vector<Point> circle;
    for (std::size_t i = 0; i < few; ++i) {
      const double at = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(few);
      circle.push_back({std::cos(at), std::sin(at), 5});
    }
    for (const double j : jaggedness(circle, in_a_row(few))) CHECK(j == 0);
  }
  for (const double j : jaggedness(saw(0, 0.9), in_a_row(n))) CHECK(j == 1);
}

TEST_CASE("where half a loop is jagged its far parts are told apart") {
  const std::vector<double> j = jaggedness(saw(n / 2, 0.9), in_a_row(n));
  CHECK(j[n / 4] == 0);
  CHECK(j[3 * n / 4] == 1);
}

TEST_CASE("the mean over a window is that of a plain sum") {
  const std::vector<Point> points = saw(n / 2, 0.2);
  const std::vector<double> j = jaggedness(points, in_a_row(n));
  for (const std::size_t i : {0u, 31u, 32u, 99u, 120u, 199u}) {
    double mean = -2 * std::numbers::pi / n;
    for (int k = -32; k <= 32; ++k) {
      const Point a = points[(i + n + k - 1) % n], b = points[(i + n + k) % n],
                  c = points[(i + n + k + 1) % n];
      mean += std::atan2(norm(cross(b - a, c - b)), dot(b - a, c - b)) / 65;
    }
    CHECK(j[i] == doctest::Approx(std::clamp((mean - 0.15) / 0.2, 0.0, 1.0)));
  }
}

TEST_CASE("only long loops are known to be even, and only where they are") {
  std::vector<Point> points = saw(0, 0);
  points.push_back({0, 0, 0});
  const std::vector<double> even = evenness(points, {in_a_row(n)});
  REQUIRE(even.size() == n + 1);
  CHECK(even[7] == 1);
  CHECK(even[n] == 0);
  CHECK(evenness(points, {in_a_row(20)})[7] == 0);
}
