// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/arrange.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "base/random.h"
#include "shapes.h"

namespace rimline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Point> random_points(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

TEST_CASE("points with a coordinate that is no number, and later duplicates, are left out and named") {
  const std::vector<Point> points{
      {1, 2, 3}, {nan, 0, 0}, {4, 5, 6}, {1, 2, 3}, {0, std::numeric_limits<double>::infinity(), 0}};
  const Arrangement a = arrange(points, {});
  CHECK(a.points.size() == 2);
  CHECK(a.not_finite == std::vector<Index>{1, 4});
  CHECK(a.duplicates == std::vector<Index>{3});
}

TEST_CASE("every id appears once and the points are the input's less the origin") {
  const auto points = random_points(1000, 3);
  const Arrangement a = arrange(points, {});
  std::vector<Index> ids = a.ids;
  std::sort(ids.begin(), ids.end());
  for (Index i = 0; i < 1000; ++i) CHECK(ids[i] == i);
  for (Index i = 0; i < 1000; ++i) CHECK(distance(a.points[i] + a.origin, points[a.ids[i]]) < 1e-15);
}

TEST_CASE("permuting the input does not change the arranged points") {
  const auto points = random_points(1000, 4);
  auto permuted = points;
  Random(9).shuffle(permuted);
  CHECK(arrange(points, {}).points == arrange(permuted, {}).points);
}

TEST_CASE("points within one cell of the curve are in an order that only their coordinates decide") {
  // Far points make the cells so large that all others share a few. There are too many of them to be left
  // out.
  auto points = random_points(500, 6);
  for (std::size_t i = 0; i < 100; ++i) points.push_back(points[3 * i]);
  for (int i = 0; i < 20; ++i) points.push_back({1e9, 1e9, 1e9 + i});
  auto permuted = points;
  Random(10).shuffle(permuted);
  const Arrangement a = arrange(points, {}), b = arrange(permuted, {});
  CHECK(a.points == b.points);
  CHECK(a.points.size() == 520);
  for (std::size_t i = 0; i < 100; ++i) CHECK(a.duplicates[i] == 500 + static_cast<Index>(i));
}

TEST_CASE("the curve visits the eight cells of a cube in the order x, y, z") {
  const std::vector<Point> cube{{1, 1, 1}, {0, 1, 1}, {1, 0, 1}, {0, 0, 1},
                                {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  CHECK(arrange(cube, {}).ids == std::vector<Index>{7, 6, 5, 4, 3, 2, 1, 0});
}

// Bit by bit, of the cell of a point among 2^21 - 1 an axis: the oracle.
std::uint64_t code_by_bits(Point p, Point low, double extent) {
  const double scale = ((1 << 21) - 1) / extent;
  const std::array<double, 3> offsets{p.x - low.x, p.y - low.y, p.z - low.z};
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint64_t>(offsets[axis] * scale);
    for (int bit = 0; bit < 21; ++bit) code |= (cell >> bit & 1) << (3 * bit + axis);
  }
  return code;
}

TEST_CASE("many points are in the order of the curve, then of their coordinates, then of their ids") {
  for (const double far : {1.0, 3e2, 1e5, 1e9}) {  // few points a cell to all in a few
    auto points = random_points(70'000, 16);
    for (std::size_t i = 0; i < points.size(); i += 3) points[i].z = 0.3;
    for (std::size_t i = 500; i < points.size(); i += 500) points[i] = points[i / 2];
    points[0] = {0, 0, 0};
    for (std::size_t i = 1; i < points.size(); i += 50) points[i].x = far;  // too many to be left out
    for (std::size_t i = 2; i < points.size(); i += 777) points[i].y = nan;
    std::vector<std::tuple<std::uint64_t, double, double, double, Index>> sorted;
    Arrangement expected;
    for (Index i = 0; i < points.size(); ++i) {
      const Point p = points[i];
      if (is_finite(p)) {
        sorted.emplace_back(code_by_bits(p, {0, 0, 0}, std::max(far, 1.0)), p.x, p.y, p.z, i);
      } else {
        expected.not_finite.push_back(i);
      }
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const Index id = std::get<4>(sorted[i]);
      const bool repeats = i > 0 && points[id] == points[std::get<4>(sorted[i - 1])];
      (repeats ? expected.duplicates : expected.ids).push_back(id);
    }
    std::sort(expected.duplicates.begin(), expected.duplicates.end());
    for (const int threads : {1, 2}) {
      Run run;
      run.threads = threads;
      const Arrangement a = arrange(points, run);
      CHECK(a.ids == expected.ids);
      CHECK(a.duplicates == expected.duplicates);
      CHECK(a.not_finite == expected.not_finite);
    }
  }
}

TEST_CASE("points next to each other on the curve are near each other in space") {
  const auto points = random_points(20'000, 5);
  const Arrangement a = arrange(points, {});
  double arranged = 0, given = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    arranged += distance(a.points[i], a.points[i - 1]);
    given += distance(points[i], points[i - 1]);
  }
  CHECK(arranged < given / 10);
}

TEST_CASE("a lonely point and a group of five, far away, are stray; a group of twelve is not") {
  auto points = shapes::disc(14).points;
  const Index first = static_cast<Index>(points.size());
  points.push_back({30, 0, 0});
  for (int i = 0; i < 5; ++i) points.push_back({0, 40 + 0.01 * i, 0.01 * i * i});
  for (int i = 0; i < 12; ++i) points.push_back({-50 + 0.01 * i, 0, 0.01 * i * i});
  Arrangement a = arrange(points, {});
  CHECK(leave_out_stray(a, find_neighbours(a.points, 10, {})));
  CHECK(a.stray == std::vector<Index>{first, first + 1, first + 2, first + 3, first + 4, first + 5});
  CHECK(a.points.size() == points.size() - 6);
}

TEST_CASE("stray points are those of small parts of the mutual graph, by a walk over all of its edges") {
  for (const int size : {400, 60000}) {  // and one that is worked on in blocks
    auto points = random_points(size, 8);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = 0.02 * points[i] + 1.0 * points[i - i % (2 + i % 13)];
    }
    const Arrangement all = arrange(points, {});
    const Index count = static_cast<Index>(all.points.size());
    const Neighbours neighbours = find_neighbours(all.points, 5, {});
    std::vector<Index> expected;
    std::vector<char> met(all.points.size(), 0);
    for (Index start = 0; start < count; ++start) {
      if (met[start]) continue;
      std::vector<Index> part{start};
      met[start] = 1;
      for (std::size_t at = 0; at < part.size(); ++at) {
        for (const Index j : neighbours.of(part[at])) {
          const auto back = neighbours.of(j);
          if (met[j] || std::find(back.begin(), back.end(), part[at]) == back.end()) continue;
          met[j] = 1;
          part.push_back(j);
        }
      }
      for (const Index i : part) {
        if (part.size() < 10) expected.push_back(all.ids[i]);
      }
    }
    std::sort(expected.begin(), expected.end());
    Arrangement a = all;
    CHECK(leave_out_stray(a, neighbours));
    CHECK(expected.size() > 20);
    CHECK(a.stray == expected);
  }
}

TEST_CASE("a clean disc has no stray points") {
  Arrangement a = arrange(shapes::disc(14).points, {});
  CHECK_FALSE(leave_out_stray(a, find_neighbours(a.points, 40, {})));
}

TEST_CASE("coordinates whose sum overflows are still arranged") {
  const Arrangement a = arrange(std::vector<Point>{{1.7e308, 0, 0}, {1.6e308, 1, 0}, {1.65e308, 0, 1}}, {});
  CHECK(a.points.size() == 3);
  for (const Point& p : a.points) CHECK(is_finite(p));
}

TEST_CASE("a box that is too large or too small to be scaled leaves points in the order of coordinates") {
  // Run under sanitizers: no number that is infinite or none becomes a cell.
  for (const double size : {1.7e308, 5e-324}) {
    const std::vector<Point> points{
        {size, -size, 0}, {0, size, 0}, {-size, 0, size}, {0, 0, -size}, {0, 0, 0}};
    CHECK(arrange(points, {}).ids == std::vector<Index>{2, 3, 4, 1, 0});
  }
}

TEST_CASE("nothing but numbers that are none throws") {
  CHECK_THROWS_AS(arrange(std::vector<Point>{{nan, 0, 0}}, {}), Error);
  CHECK_THROWS_AS(arrange(std::vector<Point>{}, {}), Error);
}

}  // namespace
}  // namespace rimline
