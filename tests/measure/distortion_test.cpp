// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "rimline/measure.h"

namespace rimline {

TEST_CASE("a map that keeps everything distorts nothing, whatever its scale") {
  const std::vector<Point> points = {{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {0, 1, 5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  std::vector<UV> uv;
  for (const Point& p : points) uv.push_back({7 * p.x + 1, 7 * p.y});
  const Distortion d = measure_distortion(points, triangles, uv, {}, 1, {});
  CHECK(d.whole.angle_mean == doctest::Approx(0).epsilon(1e-12));
  CHECK(d.whole.area_least == doctest::Approx(1));
  CHECK(d.whole.area_most == doctest::Approx(1));
  CHECK(d.whole.stretch_l2 == doctest::Approx(1));
  CHECK(d.whole.stretch_linf == doctest::Approx(1));
}

TEST_CASE("a square drawn twice as wide has the angles, singular values and stretch that one can work out") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  std::vector<UV> uv;
  for (const Point& p : points) uv.push_back({2 * p.x, p.y});
  const Distortion d = measure_distortion(points, triangles, uv, {}, 1, {});
  // Scaled to equal area the map shrinks lengths by sqrt(2) one way and stretches by sqrt(2) the other.
  CHECK(d.whole.stretch_linf == doctest::Approx(std::sqrt(2)));
  CHECK(d.whole.stretch_l2 == doctest::Approx(std::sqrt((2 + 0.5) / 2)));
  const double turned = std::numbers::pi / 4 - std::atan(0.5);
  CHECK(d.whole.angle_mean == doctest::Approx(2 * turned / 3));
  CHECK(d.triangle.angle[0] == doctest::Approx(2 * turned / 3));
  CHECK(d.point.stretch[1] == doctest::Approx(std::sqrt(1.25)));
}

TEST_CASE("each component is compared at its own scale, and a point of no triangle has no value") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0},
                                     {6, 0, 0}, {5, 1, 0}, {9, 9, 9}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<UV> uv = {{0, 0}, {1, 0}, {0, 1}, {3, 0}, {6, 0}, {3, 3}, {0, 0}};
  const std::vector<Index> component = {0, 1};
  const Distortion d = measure_distortion(points, triangles, uv, component, 2, {});
  REQUIRE(d.components.size() == 2);
  CHECK(d.components[1].stretch_linf == doctest::Approx(1));
  CHECK(d.triangle.area[1] == doctest::Approx(1));
  CHECK(std::isnan(d.point.angle[6]));
}

}  // namespace rimline
