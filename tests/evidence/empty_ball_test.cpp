// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/empty_ball.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace rimline;

namespace {

// An edge of length 1 at the upper rim of a half plane of points, and more of them above it.
double radius(std::vector<Point> above) {
  std::vector<Point> points{{-0.5, 0, 0}, {0.5, 0, 0}, {0, -1, 0}};
  for (int x = -3; x <= 3; ++x) points.push_back({x + 0.5, -2, 0});
  points.insert(points.end(), above.begin(), above.end());
  const Neighbours neighbours = find_neighbours(points, static_cast<int>(points.size()) - 1, {});
  return empty_ball_radius(points, neighbours, std::vector<double>(points.size(), 1), 0, 1, 2);
}

}  // namespace

TEST_CASE("with nothing beyond an edge the empty ball is as large as is looked for") {
  CHECK(radius({}) == 5);
}

TEST_CASE("a point beyond the edge bounds the ball through both ends and it") {
  // The circle through (-1/2, 0), (1/2, 0) and (0, h) has the radius (1/4 + h^2) / 2 h.
  for (const double h : {0.8, 1.0, 2.0, 4.0})
    CHECK(radius({{0, h, 0}}) == doctest::Approx((0.25 + h * h) / (2 * h)));
  CHECK(radius({{0, 2, 0}, {0, 1, 0}}) == doctest::Approx(0.625));
}

TEST_CASE("a point within the circle over the edge leaves no ball whose centre lies beyond") {
  CHECK(radius({{0, 0.3, 0}}) == 0);
}

TEST_CASE("points off the plane count as those in it do") {
  CHECK(radius({{0, 1, 1}}) == doctest::Approx(std::sqrt(0.875 * 0.875 + 0.25)));
}
