// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "rimline/measure.h"
#include "rimline/run.h"

namespace rimline {
namespace {

// The least distance to many places of a triangle, by trying them.
double tried(Point p, Point a, Point b, Point c) {
  double least = 1e300;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double s = 1.0 * i / steps, t = 1.0 * j / steps;
      least = std::min(least, distance(p, a + s * (b - a) + t * (c - a)));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("the distance to a mesh is the least over its triangles") {
  Random random(3);
  const auto any = [&] { return Point{random.uniform(), random.uniform(), random.uniform()}; };
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (Index i = 0; i < 40; ++i) {
    const Point at = any();
    for (int c = 0; c < 3; ++c) points.push_back(at + 0.2 * any());
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const SurfaceDistance surface(points, triangles);
  for (int trial = 0; trial < 20; ++trial) {
    const Point p = any();
    double least = 1e300;
    for (const Triangle& t : triangles)
      least = std::min(least, tried(p, points[t[0]], points[t[1]], points[t[2]]));
    CHECK(surface.to(p) <= least);
    CHECK(surface.to(p) > least - 0.01);
  }
}

TEST_CASE("two parallel squares are as far apart as they are, and half of one sticks out") {
  const std::vector<Point> low = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Point> high = {{0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {0, 1, 2}};
  const std::vector<Triangle> square = {{0, 1, 2}, {0, 2, 3}};
  const DistanceSummary to_high = SurfaceDistance(high, square).from(low, square, {});
  CHECK(to_high.mean == doctest::Approx(2));
  CHECK(to_high.rms == doctest::Approx(2));
  CHECK(to_high.most == doctest::Approx(2));
  const DistanceSummary to_low = SurfaceDistance(low, square).from(high, square, {});
  CHECK(to_low.most == doctest::Approx(std::sqrt(5)));
  CHECK(to_low.mean > 2);
}

TEST_CASE("edges agree as F1 of the two sets says") {
  CHECK(edge_agreement({{0, 1, 2}, {0, 2, 3}}, {{0, 1, 2}, {0, 2, 3}}) == 1);
  CHECK(edge_agreement({{0, 1, 2}, {0, 2, 3}}, {{0, 1, 3}, {1, 2, 3}}) == doctest::Approx(0.8));
}

TEST_CASE("a reference without triangles is refused") {
  const std::vector<Point> points = {{0, 0, 0}};
  const std::vector<Triangle> nothing;
  CHECK_THROWS_AS(SurfaceDistance(points, nothing), Error);
}

}  // namespace rimline
