// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/angle_error.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "grids.h"
#include "map/free_chart.h"

namespace rimline {
namespace {

// A square of n x n cells, its heights a wave of so much.
shapes::Mesh waves(int n, double height) {
  shapes::Mesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i)
      mesh.points.push_back({1.0 * i, 1.0 * j, height * std::sin(7.0 * i * i + 3.0 * j)});
  }
  mesh.triangles = shapes::cells(n, n, [=](int i, int j) { return static_cast<Index>(i + (n + 1) * j); });
  return mesh;
}

}  // namespace

TEST_CASE("a flat square laid flat has no error, sheared by one side that of 45 degrees") {
  const shapes::Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const OpenMesh open = open_surface(square.points, square.triangles);
  std::vector<UV> uv;
  for (const Point p : open.points) uv.push_back({p.x, p.y});
  CHECK(angle_error(open, uv).corner == doctest::Approx(0));
  for (UV& p : uv) p.u += p.v;
  // (45, 90, 45) becomes (26.57, 135, 18.43) in both triangles.
  const double wanted = (2 * 45.0) / 3 * std::numbers::pi / 180;
  CHECK(angle_error(open, uv).corner == doctest::Approx(wanted));
  CHECK(angle_error(open, uv).area == doctest::Approx(wanted));
}

TEST_CASE("no disc's map is below the least that is told, and it is told as nothing for a regular polygon") {
  for (const double height : {0.0, 0.3, 2.0}) {
    const shapes::Mesh mesh = waves(12, height);
    const OpenMesh open = open_surface(mesh.points, mesh.triangles);
    const AngleError least = least_error_of_disc(open), error = error_of_disc(open, 1e-10, {});
    CHECK(least.corner > 0);
    CHECK(least.area > 0);
    CHECK(least.corner <= error.corner);
    CHECK(least.area <= error.area);
  }
  shapes::Mesh polygon;
  polygon.points.push_back({0, 0, 0});
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    polygon.points.push_back({std::cos(angle), std::sin(angle), 0});
    polygon.triangles.push_back({0, static_cast<Index>(1 + i), static_cast<Index>(1 + (i + 1) % 6)});
  }
  const OpenMesh open = open_surface(polygon.points, polygon.triangles);
  CHECK(least_error_of_disc(open).corner == doctest::Approx(0));
  CHECK(error_of_disc(open, 1e-10, {}).corner == doctest::Approx(0));
}

}  // namespace rimline
