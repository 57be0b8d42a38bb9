// SPDX-License-Identifier: GPL-3.0-or-later
#include "view.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace rimline;
using namespace rimline::cli;

namespace {

// A sphere of radius 1 without what lies below z = -0.8, and the loop around that opening.
struct OpenSphere {
  std::vector<Point> points;
  std::vector<Loop> loops{1};

  OpenSphere() {
    for (int j = 0; j <= 20; ++j) {
      const double z = -0.8 + 1.75 * j / 20, r = std::sqrt(1 - z * z);
      for (int i = 0; i < 40; ++i) {
        const double a = 2 * 3.14159265358979 * i / 40;
        if (j == 0) loops[0].points.push_back(static_cast<Index>(points.size()));
        points.push_back({r * std::cos(a), r * std::sin(a), z});
      }
    }
    loops[0].length = 1;
  }
};

void check_right_angles(const View& view) {
  CHECK(norm(view.right) == doctest::Approx(1));
  CHECK(norm(view.up) == doctest::Approx(1));
  CHECK(norm(view.toward) == doctest::Approx(1));
  CHECK(std::abs(dot(view.right, view.up)) < 1e-12);
  CHECK(std::abs(dot(view.up, view.toward)) < 1e-12);
  CHECK(norm(cross(view.right, view.up) - view.toward) < 1e-12);
}

}  // namespace

TEST_CASE("what opens to one side stands on its opening, however it was turned") {
  const OpenSphere sphere;
  for (int turn = 0; turn < 6; ++turn) {
    std::vector<Point> turned;
    for (const Point p : sphere.points) {
      const Point cyclic = turn % 3 == 0 ? p : turn % 3 == 1 ? Point{p.y, p.z, p.x} : Point{p.z, p.x, p.y};
      turned.push_back(turn < 3 ? cyclic : -1.0 * cyclic);
    }
    const View view = choose_view(turned, sphere.loops, {}, std::nullopt);
    check_right_angles(view);
    CHECK(view.project(turned.front()).y < -0.3);
  }
}

TEST_CASE("a sheet is looked at from the side it faces") {
  std::vector<Point> sheet;
  for (int i = 0; i < 100; ++i) sheet.push_back({i % 10 * 2.0, i / 10 * 1.0, 0});
  for (const double side : {1.0, -1.0}) {
    const View view = choose_view(sheet, {}, {0, 0, side}, std::nullopt);
    check_right_angles(view);
    CHECK(side * view.toward.z > 0.5);
  }
}

TEST_CASE("the way up that was asked for is up in the picture") {
  const OpenSphere sphere;
  for (const Point up : {Point{0, 1, 0}, Point{-3, 0, 0}, Point{0, 0, -1}}) {
    const View view = choose_view(sphere.points, sphere.loops, {}, up);
    check_right_angles(view);
    CHECK(dot(view.up, up) > 0.7 * norm(up));
  }
}

TEST_CASE("no points, or points in one place, still give a view") {
  check_right_angles(choose_view({}, {}, {}, std::nullopt));
  const std::vector<Point> one(5, Point{1, 2, 3});
  check_right_angles(choose_view(one, {}, {}, std::nullopt));
}
