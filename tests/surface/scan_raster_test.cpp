// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/scan_raster.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/random.h"

namespace rimline {
namespace {

constexpr int columns = 60, rows = 40;
constexpr double column_angle = 0.02;

// What a scanner at the origin sees, column by column, row by row; a direction without an answer has no
// sample.
struct Scan {
  std::vector<Point> points;
  std::vector<RasterCell> cells;
};

Point direction(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

// `range`: of a direction; 0 where nothing is.
template <class Range>
Scan scan(double row_angle, const Range& range, double turn = column_angle * columns) {
  Scan seen;
  for (Index column = 0; column < columns; ++column) {
    for (Index row = 0; row < rows; ++row) {
      const Point d = direction((column - 0.5 * columns) * turn / columns, (row - 0.5 * rows) * row_angle);
      const double r = range(d);
      if (r == 0) continue;
      seen.points.push_back(r * d);
      seen.cells.push_back({column, row});
    }
  }
  return seen;
}

// A wall at x = 3, and a ball of radius 0.25 before it.
constexpr Point ball{2, 0, 0};
double ball_before_wall(Point d) {
  const double along = dot(d, ball), beside = dot(ball, ball) - along * along;
  return beside < 0.0625 ? along - std::sqrt(0.0625 - beside) : 3 / d.x;
}

bool is_on_ball(Point p) { return p.x < 2.5; }

std::optional<std::vector<Triangle>> triangles(const Scan& scan) {
  const Neighbours neighbours = find_neighbours(scan.points, 16, {});
  auto image = image_of_raster(scan.points, neighbours, scan.cells, {});
  if (!image) return std::nullopt;
  return std::move(image->triangles);
}

// Edges of one triangle.
std::size_t rim_edges(const std::vector<Triangle>& mesh) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Triangle& t : mesh) {
    for (int i = 0; i < 3; ++i) ++count[std::minmax(t[i], t[(i + 1) % 3])];
  }
  return static_cast<std::size_t>(std::ranges::count_if(count, [](const auto& e) { return e.second == 1; }));
}

TEST_CASE("a spherical scan of a wall has both halves of every cell, whatever the rows are to the columns") {
  for (const double row_angle : {0.02, 0.002, 0.03}) {
    CAPTURE(row_angle);
    const auto mesh = triangles(scan(row_angle, [](Point d) { return 3 / d.x; }));
    REQUIRE(mesh.has_value());
    CHECK(mesh->size() == 2 * (columns - 1) * (rows - 1));
    CHECK(rim_edges(*mesh) == 2 * (columns - 1 + rows - 1));
  }
}

TEST_CASE("a ball before a wall is joined to it by no triangle, and no whole cell of either is lost") {
  const Scan seen = scan(0.02, ball_before_wall);
  const auto mesh = triangles(seen);
  REQUIRE(mesh.has_value());
  std::map<std::pair<Index, Index>, int> on_ball;  // of the raster's cells; 1 on the ball, 0 on the wall
  for (std::size_t i = 0; i < seen.points.size(); ++i)
    on_ball[{seen.cells[i].column, seen.cells[i].row}] = is_on_ball(seen.points[i]);
  std::size_t halves = 0;
  for (Index c = 0; c + 1 < columns; ++c) {
    for (Index r = 0; r + 1 < rows; ++r) {
      const int count = on_ball[{c, r}] + on_ball[{c + 1, r}] + on_ball[{c, r + 1}] + on_ball[{c + 1, r + 1}];
      halves += count == 0 || count == 4 ? 2 : count == 1 || count == 3 ? 1 : 0;
    }
  }
  CHECK(mesh->size() <= halves);
  CHECK(mesh->size() >= halves - 40);  // the ball's rim is seen at a glancing angle
  for (const Triangle& t : *mesh) {
    CHECK(is_on_ball(seen.points[t[0]]) == is_on_ball(seen.points[t[1]]));
    CHECK(is_on_ball(seen.points[t[0]]) == is_on_ball(seen.points[t[2]]));
  }
}

TEST_CASE(
    "samples that are missing leave holes of their cells alone, and the order of the points tells nothing") {
  Scan seen =
      scan(0.02, [](Point d) { return std::abs(d.y) < 0.11 && std::abs(d.z) < 0.11 ? 0.0 : 3 / d.x; });
  const auto before = triangles(seen);
  REQUIRE(before.has_value());
  Random random(4);
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    const std::size_t j = random.below(seen.points.size());
    std::swap(seen.points[i], seen.points[j]);
    std::swap(seen.cells[i], seen.cells[j]);
  }
  const auto after = triangles(seen);
  REQUIRE(after.has_value());
  CHECK(before->size() == after->size());
  CHECK(rim_edges(*before) == rim_edges(*after));
  CHECK(before->size() < 2 * (columns - 1) * (rows - 1));
}

TEST_CASE("a full turn has no rim where it closes") {
  const auto room = [](Point d) { return 3 / std::hypot(d.x, d.y); };
  const auto closed = triangles(scan(0.05, room, 2 * std::numbers::pi));
  REQUIRE(closed.has_value());
  CHECK(closed->size() == 2 * columns * (rows - 1));
  CHECK(rim_edges(*closed) == 2 * columns);
  const auto open = triangles(scan(0.05, room, 1.8 * std::numbers::pi));
  REQUIRE(open.has_value());
  CHECK(open->size() == 2 * (columns - 1) * (rows - 1));
}

TEST_CASE("cells that do not fit the points, or hold two, are no raster") {
  const Scan wall = scan(0.02, [](Point d) { return 3 / d.x; });
  Scan twice = wall, mixed = wall, few = wall;
  twice.cells[7] = twice.cells[8];
  CHECK_FALSE(triangles(twice).has_value());
  Random random(5);
  random.shuffle(mixed.cells);
  CHECK_FALSE(triangles(mixed).has_value());
  few.points.resize(100);
  few.cells.resize(100);
  CHECK_FALSE(triangles(few).has_value());
  Scan far = wall;  // the largest ids that there can be
  for (RasterCell& cell : far.cells) {
    cell.column += 2147483646 - columns;
    cell.row += 2147483646 - rows;
  }
  CHECK(triangles(far) == triangles(wall));
}

}  // namespace
}  // namespace rimline
