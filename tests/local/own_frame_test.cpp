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

TEST_CASE("points are strewn evenly, and the same ones where the cloud is turned") {
  const std::vector<Point> points = saddle(), other = turned(points);
  const OwnFrame own = own_frame(points, {}), own_turned = own_frame(other, {});
  int below = 0, different = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_below = strewn(own, points[i]) < 1.0 / 6;
    below += is_below;
    different += is_below != (strewn(own_turned, other[i]) < 1.0 / 6);
  }
  CHECK(below > 400);
  CHECK(below < 600);
  CHECK(different == 0);
}

TEST_CASE("moments are sums over the points, and those of parts add up to those of the whole") {
  const std::vector<Point> points = saddle();
  const Moments whole = moments_of(points, {});
  Moments sum;
  sum += moments_of(Points(points).subspan(2000), {});
  sum += moments_of(Points(points).subspan(1, 1999), {});
  sum += moments_of(Points(points).first(1), {});
  CHECK(sum.count == static_cast<double>(points.size()));
  CHECK(distance(sum.mean, whole.mean) < 1e-12);
  for (int i = 0; i < 6; ++i) CHECK(sum.second[i] == doctest::Approx(whole.second[i]).epsilon(1e-9));
  for (int i = 0; i < 10; ++i) CHECK(sum.third[i] == doctest::Approx(whole.third[i]).epsilon(1e-9));
  double xyy = 0, zzz = 0;
  for (const Point p : points) {
    const Point d = p - whole.mean;
    xyy += d.x * d.y * d.y;
    zzz += d.z * d.z * d.z;
  }
  CHECK(whole.third[3] == doctest::Approx(xyy).epsilon(1e-9));
  CHECK(whole.third[9] == doctest::Approx(zzz).epsilon(1e-9));
}
