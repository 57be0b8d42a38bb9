// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/far_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rimline/arrange.h"
#include "rimline/pipeline.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

PointBox box_of(const std::vector<Point>& points) {
  PointBox box;
  for (const Point& p : points) box.add(p);
  return box;
}

std::vector<Point> surface() {
  SampleOptions options;
  options.shape = Shape::SphereMinusCap;
  options.sampling = Sampling::Random;
  options.n = 800;
  return sample(options, Run{}).points;
}

std::vector<Point> with(std::vector<Point> points, std::initializer_list<Point> more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

TEST_CASE("ordinary clouds have no far points: uneven ones, planes, lines, one place") {
  const std::vector<Point> even = surface();
  CHECK(!box_without_far_points(even, box_of(even), Run{}));
  std::vector<Point> uneven, plane, line, place(20, Point{1, 2, 3});
  for (int i = 0; i < 400; ++i) {
    const double t = i / 400.0;
    uneven.push_back({std::pow(10.0, -12 * t), t, 0});
    plane.push_back({7, std::sin(1e3 * i), std::cos(2e3 * i)});
    line.push_back({t, t, t});
  }
  for (const auto& points : {uneven, plane, line, place, std::vector<Point>{{0, 0, 0}, {1e300, 0, 0}}}) {
    CHECK(!box_without_far_points(points, box_of(points), Run{}));
  }
}

TEST_CASE("a few points out of proportion are outside of the box, all others in it, whatever their order") {
  std::vector<Point> points = with(surface(), {{1e9, 0, 0}, {0, -1e30, 0}, {0, 0, 1e308}});
  for (int turn = 0; turn < 2; ++turn) {
    const auto near = box_without_far_points(points, box_of(points), Run{});
    REQUIRE(near);
    CHECK(std::ranges::count_if(points, [&](Point p) { return !near->has(p); }) == 3);
    std::ranges::reverse(points);
  }
}

TEST_CASE("where more than one of a hundred points are far, they are data") {
  std::vector<Point> points = surface();
  for (int i = 0; i < 20; ++i) points.push_back({1e12, 1e12 * i, 0});
  CHECK(!box_without_far_points(points, box_of(points), Run{}));
}

TEST_CASE("one far point moves nothing: the others keep every bit, and it is stray") {
  const std::vector<Point> points = surface();
  const Arrangement alone = arrange(points, Run{});
  for (const double far : {1e8, 1e18, 1e30, 1e100}) {
    CAPTURE(far);
    const Arrangement both = arrange(with(points, {{-far, far, 0}}), Run{});
    CHECK(both.origin == alone.origin);
    CHECK(both.points == alone.points);
    CHECK(both.ids == alone.ids);
    CHECK(both.stray == std::vector<Index>{800});
  }
}

TEST_CASE("loops, triangles and map are the same with a far point as without, at any scale") {
  const std::vector<Point> points = surface();
  const Options options = preset_options(Preset::Default);
  const ReconstructResult alone = reconstruct(points, options, Run{});
  for (const int exponent : {-990, 0, 990}) {
    CAPTURE(exponent);
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p = std::ldexp(1.0, exponent) * p;
    for (const double far : {1e30, std::numeric_limits<double>::max()}) {
      if (exponent > 0 && far < 1e300) continue;  // not far at all
      CAPTURE(far);
      const ReconstructResult both = reconstruct(with(scaled, {{far, 0, 0}}), options, Run{});
      CHECK(both.triangles == alone.triangles);
      CHECK(both.boundary.loops.size() == alone.boundary.loops.size());
      CHECK(both.boundary.loops.at(0).points == alone.boundary.loops.at(0).points);
      CHECK(std::equal(alone.uv.begin(), alone.uv.end(), both.uv.begin()));
      CHECK(both.boundary.report.points.stray == 1);
    }
  }
}

}  // namespace
}  // namespace rimline
