// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/cut_plane.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace rimline;

namespace {

constexpr int around = 60, rows = 12;

// A tube about the z-axis of squares of side 1, or the sheet that it unrolls to. Every other point of the
// lowest row, which is at z = 0, is cut off.
struct Tube {
  explicit Tube(bool rolled) {
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < around; ++i) {
        if (row == 0 && i % 2 == 1) continue;
        const double angle = 2 * std::numbers::pi * i / around, radius = around / (2 * std::numbers::pi);
        const Point on_tube{radius * std::cos(angle), radius * std::sin(angle), double(row)};
        if (row < 2 && (row == 0 || i % 2 == 1)) rim.push_back(static_cast<Index>(points.size()));
        points.push_back(rolled ? on_tube : Point{double(i), double(row), 0});
      }
    }
    neighbours = find_neighbours(points, 20, {});
    spacing = local_spacing(points, neighbours);
    frames = fit_frames(points, neighbours, {});
  }

  std::optional<CutPlane> plane() const { return CutPlane::find(points, neighbours, spacing, frames, rim); }
  double depth(int row) const {
    const auto point = static_cast<Index>(around / 2 + (row - 1) * around);
    REQUIRE(points[point].z == row);
    return plane()->depth(points, neighbours, spacing, frames, point);
  }

  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<double> spacing;
  std::vector<Frame> frames;
  std::vector<Index> rim;  // not in order, which is not asked for
};

}  // namespace

TEST_CASE("the plane that cut a tube is found, and depths count from its outermost points") {
  const Tube tube(true);
  REQUIRE(tube.plane());
  CHECK(tube.depth(2) == doctest::Approx(2).epsilon(0.3));
  CHECK(tube.depth(5) - tube.depth(2) == doctest::Approx(3).epsilon(0.3));
}

TEST_CASE("no plane has cut a flat sheet, a rim of few points or one that is not flat") {
  CHECK_FALSE(Tube(false).plane());
  Tube tube(true);
  tube.rim.resize(40);
  CHECK_FALSE(tube.plane());
  Tube slanting(true);
  for (std::size_t i = 0; i < slanting.rim.size() / 4; ++i) {
    slanting.rim[i] = static_cast<Index>(slanting.points.size() - 1 - i);
  }
  CHECK_FALSE(slanting.plane());
}
