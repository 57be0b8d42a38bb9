// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/own_frame.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rimline/sample.h"

using namespace rimline;

namespace {

std::vector<Point> saddle() {
  SampleOptions options;
  options.shape = Shape::WavySaddle;
  options.n = 3000;
  return sample(options, {}).points;
}

// By 30 degrees about an axis askew, and moved.
std::vector<Point> turned(Points points) {
  const double c = std::cos(0.5235987755982988), s = std::sin(0.5235987755982988);
  const Point axis = (1 / std::sqrt(14.0)) * Point{1, 2, 3};
  std::vector<Point> result;
  for (const Point p : points)
    result.push_back(c * p + s * cross(axis, p) + (1 - c) * dot(axis, p) * axis + Point{5, -7, 2});
  return result;
}

}  // namespace

TEST_CASE("points have the same places in the frame of a cloud that is turned") {
  const std::vector<Point> points = saddle(), other = turned(points);
  const OwnFrame a = own_frame(points, {}), b = own_frame(other, {});
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(distance(a.in(points[i] - a.centre), b.in(other[i] - b.centre)) < 1e-9);
}

TEST_CASE("the axes are unit vectors across each other, and out() takes back what in() did") {
  const std::vector<Point> points = saddle();
  const OwnFrame own = own_frame(points, {});
  CHECK(norm(cross(own.axes[0], own.axes[1]) - own.axes[2]) < 1e-12);
  for (const Point p : points) CHECK(distance(own.out(own.in(p)), p) < 1e-12);
}

TEST_CASE("some of the points are about as many as asked, and the same ones where the cloud is turned") {
  const std::vector<Point> points = saddle(), other = turned(points);
  const auto some = some_of(points, own_frame(points, {}), 500, {});
  CHECK(some.size() > 400);
  CHECK(some.size() < 600);
  CHECK(some == some_of(other, own_frame(other, {}), 500, {}));
  CHECK(some_of(points, own_frame(points, {}), points.size(), {}).size() == points.size());
}
