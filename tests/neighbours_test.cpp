// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/neighbours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace rimline {
namespace {

std::vector<Point> random_points(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point> points(count);
  for (Point& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

std::vector<Point> grid_points(int side) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) points.push_back({1.0 * x, 1.0 * y, 0});
  }
  return points;
}

// All points, sorted: the oracle.
std::vector<Index> nearest_by_brute_force(Points points, Index self, int k) {
  std::vector<std::tuple<double, double, double, double, Index>> all;
  for (Index i = 0; i < points.size(); ++i) {
    if (i != self)
      all.emplace_back(squared_distance(points[self], points[i]), points[i].x, points[i].y, points[i].z, i);
  }
  std::sort(all.begin(), all.end());
  std::vector<Index> ids;
  for (int j = 0; j < k; ++j) ids.push_back(std::get<4>(all[j]));
  return ids;
}

void check_against_brute_force(Points points, int k) {
  const Neighbours neighbours = find_neighbours(points, k, {});
  for (Index i = 0; i < points.size(); ++i) {
    const auto list = neighbours.of(i);
    CHECK(std::vector<Index>(list.begin(), list.end()) == nearest_by_brute_force(points, i, k));
  }
}

TEST_CASE("the neighbours of random points are those of brute force") {
  for (const unsigned seed : {1u, 2u, 3u}) check_against_brute_force(random_points(300, seed), 13);
}

TEST_CASE("ties on a grid are settled by coordinates, then id") {
  check_against_brute_force(grid_points(12), 7);
}

TEST_CASE("one and two threads give the same neighbours") {
  const auto points = random_points(5000, 4);
  Run one, two;
  one.threads = 1;
  two.threads = 2;
  const Neighbours a = find_neighbours(points, 20, one), b = find_neighbours(points, 20, two);
  CHECK(a.ids == b.ids);
  CHECK(a.distance == b.distance);
}

TEST_CASE("a set smaller than k has n - 1 neighbours") {
  CHECK(find_neighbours(random_points(5, 5), 40, {}).k == 4);
}

TEST_CASE("a single point has no neighbours and says so") {
  CHECK_THROWS_AS(find_neighbours(random_points(1, 6), 4, {}), Error);
}

TEST_CASE("the spacing on a long row is the mean of the six nearest distances") {
  std::vector<Point> row;
  for (int i = 0; i < 9; ++i) row.push_back({1.0 * i, 0, 0});
  CHECK(local_spacing(find_neighbours(row, 8, {}))[4] == doctest::Approx((1 + 1 + 2 + 2 + 3 + 3) / 6.0));
}

TEST_CASE("a run that was stopped throws Cancelled") {
  const std::atomic<bool> stop{true};
  Run run;
  run.stop = &stop;
  try {
    find_neighbours(random_points(100, 7), 4, run);
    FAIL("not stopped");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::Cancelled);
  }
}

}  // namespace
}  // namespace rimline
