// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/neighbours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "base/random.h"
#include "rimline/arrange.h"
#include "shapes.h"

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
  std::partial_sort(all.begin(), all.begin() + k, all.end());
  std::vector<Index> ids;
  for (int j = 0; j < k; ++j) ids.push_back(std::get<4>(all[j]));
  return ids;
}

void check_against_brute_force(Points points, int k) {
  const Neighbours neighbours = find_neighbours(points, k, {});
  std::size_t wrong_lists = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const auto list = neighbours.of(i);
    wrong_lists +=
        std::vector<Index>(list.begin(), list.end()) != nearest_by_brute_force(points, i, neighbours.k);
  }
  CHECK(wrong_lists == 0);
}

TEST_CASE("the neighbours of random points are those of brute force") {
  for (const unsigned seed : {1u, 2u, 3u}) check_against_brute_force(random_points(300, seed), 13);
}

TEST_CASE("ties on a grid are settled by coordinates, then id") {
  check_against_brute_force(grid_points(12), 7);
}

TEST_CASE("sets of every small size have the neighbours of brute force") {
  for (int count = 2; count < 70; ++count) {
    for (const int k : {1, 5, 40}) check_against_brute_force(random_points(count, count), k);
  }
}

TEST_CASE("points of a surface have the neighbours of brute force, for any k") {
  const auto disc = shapes::disc(30, 0.4);
  for (const int k : {1, 2, 8, 40, 300}) check_against_brute_force(disc.points, k);
}

TEST_CASE("a shuffled grid, where most distances tie, has the neighbours of brute force") {
  auto points = grid_points(60);
  Random(3).shuffle(points);
  check_against_brute_force(points, 40);
}

TEST_CASE("a solid of 5000 points has the neighbours of brute force") {
  check_against_brute_force(random_points(5000, 11), 40);
}

TEST_CASE("clusters a million times denser than their surroundings have the neighbours of brute force") {
  auto points = random_points(3000, 8);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 3 == 0) points[i] = 1e-6 * points[i] + points[1];
    if (i % 30 == 5) points[i] = 1e-12 * points[i] + points[2];
  }
  check_against_brute_force(points, 40);
}

TEST_CASE("points on a line have the neighbours of brute force, evenly spaced or not") {
  std::vector<Point> even, uneven;
  for (int i = 0; i < 700; ++i) {
    even.push_back({0.1 * i, 0.2 * i, -0.3 * i});
    uneven.push_back({std::pow(1.1, i), 0, 0});
  }
  check_against_brute_force(even, 12);
  check_against_brute_force(uneven, 12);
}

TEST_CASE("points a million extents away change nothing for the others and have neighbours themselves") {
  auto points = shapes::disc(20, 0.1).points;
  points.push_back({1e6, 0, 0});
  points.push_back({-1e6, 3e6, 1});
  points.push_back({1e6, 1e-3, 0});
  check_against_brute_force(points, 20);
}

TEST_CASE("a set far from the origin, where coordinates have few digits left, has those of brute force") {
  auto points = random_points(1500, 12);
  for (Point& p : points) p = 1e-3 * p + Point{4e5, 5e6, 1e9};
  check_against_brute_force(points, 25);
}

// Neighbours so close together, seen from so large a leaf, that single precision can not tell which is
// nearer.
TEST_CASE("neighbours that single precision confuses are told apart") {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> unit(0, 1), factor(0.5, 1), part(-1e-6, 1e-6);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // brute force of all takes minutes
  const int triples = 600;
#else
  const int triples = 3000;
#endif
  std::vector<Point> points;
  for (int i = 0; i < triples; ++i) {
    const Point p = {unit(random), unit(random), unit(random)};
    const double near = 1.2e-4 * factor(random);
    points.insert(points.end(), {p, p + Point{near, 0, 0}, p + Point{0, near * (1 + part(random)), 0}});
  }
  for (const int k : {1, 2}) check_against_brute_force(points, k);
}

// Two leaves: pairs at distance `near` in the one set its radius to 1.15 `near` (see `leaf_slack`), so the
// other is not gathered. A point of the first has its nearest in the other, just beyond that radius, and one
// in its own leaf beyond by so little more that single precision lets it pass.
TEST_CASE("a neighbour just beyond the radius of its leaf is not taken for the nearest") {
  const double near = 1e-3, radius = 1.15 * near, diagonal = 1.8, margin = 0x1p-20 * diagonal / radius;
  for (int trial = 0; trial < 40; ++trial) {
    const double y = 0.02 * trial + 0.1;
    std::vector<Point> points = {
        {0, y, 0}, {-radius * (1 + 0.6 * margin), y, 0}, {radius * (1 + 0.3 * margin), y, 0}, {1, y, 0}};
    for (int i = 0; i < 15; ++i) {
      const double at = i / 14.0;
      for (const double x : {-1.5, 1.5}) points.insert(points.end(), {{x, at, 0}, {x + near, at, 0}});
    }
    Random(trial).shuffle(points);  // which is searched first depends on the order
    check_against_brute_force(points, 1);
  }
}

// Rows whose spacing doubles from one to the next: what suffices for a point is too little or too much for
// the one after it in the same leaf.
TEST_CASE("points whose density changes within a leaf have the neighbours of brute force") {
  std::vector<Point> points;
  for (int row = 0; row < 12; ++row) {
    const double step = std::ldexp(1.0, row - 12);
    for (int i = 0; i < 100; ++i) points.push_back({i * step, step + 1e-3 * (i % 7) * step, 0});
  }
  Random(5).shuffle(points);
  for (const int k : {1, 6, 40}) check_against_brute_force(points, k);
}

TEST_CASE("more points within the radius than keys can tell apart have the neighbours of brute force") {
  auto points = shapes::disc(24, 0.4).points;
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> part(-1e-3, 1e-3);
  for (int i = 0; i < 600; ++i) points.push_back(Point{0.31, 0.17, 0} + Point{part(random), part(random), 0});
  for (const int k : {12, 280}) check_against_brute_force(points, k);
}

TEST_CASE("several points at one place are neighbours at distance 0") {
  auto points = random_points(400, 13);
  for (std::size_t i = 0; i < 100; ++i) points[i] = points[399];
  check_against_brute_force(points, 30);
}

TEST_CASE("distances so small or large that their squares have no double are still sorted") {
  for (const double scale : {1e-200, 1e-150, 1e150, 1e200}) {
    auto points = random_points(200, 14);
    for (Point& p : points) p = scale * p;
    check_against_brute_force(points, 9);
  }
}

// Puts the points into another order and looks whether each still has the same neighbours. No distances tie.
void check_in_any_order(Points points, const std::vector<Index>& order, const Neighbours& known) {
  std::vector<Point> ordered;
  for (const Index i : order) ordered.push_back(points[i]);
  const Neighbours neighbours = find_neighbours(ordered, known.k, {});
  std::size_t wrong_lists = 0;
  for (Index i = 0; i < ordered.size(); ++i) {
    const auto list = neighbours.of(i), known_list = known.of(order[i]);
    wrong_lists += !std::equal(list.begin(), list.end(), known_list.begin(), known_list.end(),
                               [&](Index a, Index b) { return order[a] == b; });
  }
  CHECK(wrong_lists == 0);
}

TEST_CASE("points along a Morton curve have the neighbours that they have in any order") {
  auto cloud = random_points(60'000, 21);
  for (std::size_t i = 0; i < 40'000; ++i) cloud[i].z = 0.1 * std::sin(5 * cloud[i].x);  // a sheet
  for (std::size_t i = 0; i < 20'000; ++i) cloud[i] = 1e-3 * cloud[i] + Point{0.4, 0.3, 0.2};
  const Neighbours known = find_neighbours(cloud, 12, {});
  for (Index i = 0; i < cloud.size(); i += 997) {
    const auto list = known.of(i);
    CHECK(std::vector<Index>(list.begin(), list.end()) == nearest_by_brute_force(cloud, i, 12));
  }
  auto order = arrange(cloud, {}).ids;
  check_in_any_order(cloud, order, known);
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) std::swap(order[random() % order.size()], order[random() % order.size()]);
  check_in_any_order(cloud, order, known);  // most follow the curve, so that its cells are taken
  std::rotate(order.begin(), order.begin() + 7'000, order.end());
  check_in_any_order(cloud, order, known);  // the first point lies behind the last
}

TEST_CASE("many points in one cell of the curve, beside a far one, have the neighbours of brute force") {
  auto points = random_points(20'000, 22);
  for (Point& p : points) p = 1e-9 * p;
  points.push_back({1, 1, 1});
  const Neighbours neighbours = find_neighbours(points, 5, {});
  for (Index i = 0; i < points.size(); i += 997) {
    const auto list = neighbours.of(i);
    CHECK(std::vector<Index>(list.begin(), list.end()) == nearest_by_brute_force(points, i, 5));
  }
}

TEST_CASE("one and two threads give the same neighbours") {
  const auto points = random_points(5000, 4);
  Run one, two;
  one.threads = 1;
  two.threads = 2;
  const Neighbours a = find_neighbours(points, 20, one), b = find_neighbours(points, 20, two);
  CHECK(a.ids == b.ids);
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
  CHECK(local_spacing(row, find_neighbours(row, 8, {}))[4] == doctest::Approx((1 + 1 + 2 + 2 + 3 + 3) / 6.0));
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
