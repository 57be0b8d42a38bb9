// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/domain.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "map/embed.h"

namespace rimline {
namespace {

struct Sheet {
  std::vector<Point> points;
  std::vector<Loop> loops;
};

// A flat sheet of width * height points, a little uneven inside, bent about a cylinder of that radius (0:
// flat).
Sheet make_sheet(int width, int height, double radius) {
  Sheet sheet;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool rim = x == 0 || y == 0 || x == width - 1 || y == height - 1;
      const double u = x + (rim ? 0 : 0.2 * std::sin(5.0 * x + 3 * y)),
                   v = y + (rim ? 0 : 0.2 * std::cos(4.0 * y + x));
      sheet.points.push_back(radius > 0
                                 ? Point{radius * std::sin(u / radius), v, radius * std::cos(u / radius)}
                                 : Point{u, v, 0});
    }
  }
  Loop loop;
  for (Index x = 0; x + 1 < width; ++x) loop.points.push_back(x);
  for (Index y = 0; y + 1 < height; ++y) loop.points.push_back(y * width + width - 1);
  for (Index x = width - 1; x > 0; --x) loop.points.push_back((height - 1) * width + x);
  for (Index y = height - 1; y > 0; --y) loop.points.push_back(y * width);
  sheet.loops = {loop};
  return sheet;
}

Patch refine(const Sheet& sheet, Domain domain) {
  RefineOptions options;
  options.domain = domain;
  const Run run;
  return refine_patch(sheet.points, find_neighbours(sheet.points, 20, run), sheet.loops, options, run);
}

double angle(double ax, double ay, double bx, double by) {
  return std::atan2(std::abs(ax * by - ay * bx), ax * bx + ay * by);
}

double worst_angle_error(const Sheet& sheet, const Patch& patch) {
  double worst = 0;
  for (const Triangle& t : patch.triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index p = t[c], a = t[(c + 1) % 3], b = t[(c + 2) % 3];
      const Point e = sheet.points[a] - sheet.points[p], f = sheet.points[b] - sheet.points[p];
      const double in_space = std::atan2(norm(cross(e, f)), dot(e, f));
      const UV q = patch.uv[p], r = patch.uv[a], s = patch.uv[b];
      worst = std::max(worst, std::abs(in_space - angle(r.u - q.u, r.v - q.v, s.u - q.u, s.v - q.v)));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("the free map of a flat or rolled sheet keeps every angle and every length") {
  for (const double radius : {0.0, 9.0}) {
    CAPTURE(radius);
    const Sheet sheet = make_sheet(24, 15, radius);
    const Patch patch = refine(sheet, Domain::Free);
    CHECK(patch.domain == Domain::Free);
    CHECK(patch.uv_flips == 0);
    CHECK(worst_angle_error(sheet, patch) < (radius > 0 ? 0.02 : 1e-6));
    const UV a = patch.uv[0], b = patch.uv[23];
    CHECK(std::hypot(a.u - b.u, a.v - b.v) == doctest::Approx(23).epsilon(0.01));
  }
}

TEST_CASE("the corners of a sheet are found and go to the corners of the square and of the rectangle") {
  const Sheet sheet = make_sheet(21, 11, 0);
  CHECK(find_corners(sheet.points, sheet.loops[0].points) == std::array<std::size_t, 4>{0, 20, 30, 50});
  const Patch square = refine(sheet, Domain::Square);
  const std::array<Index, 4> corners{0, 20, 230, 210};
  const std::array<UV, 4> expected{UV{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int c = 0; c < 4; ++c) CHECK(square.uv[corners[c]] == expected[c]);
  CHECK(flipped_triangles(square.triangles, square.uv, {}).empty());
  const Patch rectangle = refine(sheet, Domain::Rectangle);
  CHECK(rectangle.uv[230].v == doctest::Approx(0.5));
  CHECK(worst_angle_error(sheet, rectangle) < 0.1);  // but for the sides' bulge it is the sheet itself
  CHECK(flipped_triangles(rectangle.triangles, rectangle.uv, {}).empty());
}

TEST_CASE("corners that are not on the loop, or not four, are refused") {
  const Sheet sheet = make_sheet(8, 8, 0);
  std::vector<UV> uv(sheet.points.size());
  const std::array<Index, 4> inside{0, 7, 63, 9}, twice{0, 7, 7, 56};
  CHECK_THROWS_AS(place_outline(sheet.points, sheet.loops[0].points, Domain::Square, inside, uv), Error);
  CHECK_THROWS_AS(place_outline(sheet.points, sheet.loops[0].points, Domain::Square, twice, uv), Error);
}

}  // namespace rimline
