// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/fill_rim.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "rimline/measure.h"

namespace rimline {
namespace {

std::vector<Point> ring(int corners, double wave) {
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back({std::cos(angle), std::sin(angle), wave * std::cos(2 * angle)});
  }
  return points;
}

bool any_pair(Index, Index) { return true; }

}  // namespace

TEST_CASE("a rim is filled without vertices where no spacing is given") {
  const auto rim = ring(30, 0);
  const RimFill fill = fill_rim(rim, {}, 1000, any_pair, {});
  CHECK(fill.triangles.size() == 28);
  CHECK(fill.added.empty());
}

TEST_CASE("vertices are added at the spacing of the rim and stay within it") {
  const int corners = 60;
  const auto rim = ring(corners, 0);
  const double step = 2 * std::sin(std::numbers::pi / corners);
  const std::vector<double> spacing(corners, step);
  const RimFill fill = fill_rim(rim, spacing, 10'000, any_pair, {});
  // As many as an even triangulation of the disc has, give or take.
  const double wanted = std::numbers::pi / (0.87 * step * step);
  CHECK(static_cast<double>(fill.added.size()) > 0.3 * wanted);
  CHECK(static_cast<double>(fill.added.size()) < 1.5 * wanted);
  CHECK(fill.triangles.size() == rim.size() - 2 + 2 * fill.added.size());
  for (const Point& p : fill.added) {
    CHECK(std::abs(p.z) < 1e-6);
    CHECK(std::hypot(p.x, p.y) < 1);
  }
}

TEST_CASE("added vertices lie on the membrane: within the height of the rim") {
  const auto rim = ring(40, 0.3);
  const std::vector<double> spacing(rim.size(), 0.3);
  const RimFill fill = fill_rim(rim, spacing, 10'000, any_pair, {});
  REQUIRE(!fill.added.empty());
  for (const Point& p : fill.added) CHECK(std::abs(p.z) < 0.3);  // within the rim's own height
}

TEST_CASE("a rim with deep bays is filled by vertices without the fill meeting itself") {
  // The rim's points lie far closer than the vertices allowed: triangles at it are slim, and about the bays
  // the plain mean of a vertex's neighbours lies outside.
  std::vector<Point> rim;
  const int corners = 3000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = 1 + 0.35 * std::cos(5 * angle);
    rim.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.1 * std::sin(2 * angle)});
  }
  const std::vector<double> spacing(rim.size(), 0.003);
  const RimFill fill = fill_rim(rim, spacing, 3000, any_pair, {});
  CHECK(fill.added.size() > 1000);
  std::vector<Point> points = rim;
  points.insert(points.end(), fill.added.begin(), fill.added.end());
  CHECK(find_self_intersections(points, fill.triangles, {}).empty());
}

TEST_CASE("no more vertices are added than allowed") {
  const auto rim = ring(200, 0);
  const std::vector<double> spacing(rim.size(), 0.03);
  const RimFill fill = fill_rim(rim, spacing, 50, any_pair, {});
  CHECK(fill.added.size() <= 50);
  CHECK(!fill.added.empty());
}

}  // namespace rimline
