// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/mean_direction.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/vec.h"

using namespace rimline;

namespace {

// A lattice of 21 x 21 points, shifted out of the origin.
std::vector<Point> lattice() {
  std::vector<Point> points;
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 21; ++x) points.push_back({1.0 * x, 1.0 * y, 5});
  }
  return points;
}

}  // namespace

TEST_CASE("neighbours are all around a point inside, and on the inner side of one at the boundary") {
  const std::vector<Point> points = lattice();
  const Neighbours neighbours = find_neighbours(points, 24, {});
  const std::vector<double> spacing(points.size(), 1);
  const Samples samples = with_frames(points, neighbours, spacing, {});
  CHECK(norm(mean_direction(samples, 21 * 10 + 10, 24)) < 1e-12);
  const Point side = mean_direction(samples, 21 * 10, 13);
  CHECK(side.x > 0.5);
  CHECK(side.x < 1);
  CHECK(side.z == doctest::Approx(0));
}

TEST_CASE("heights above the tangent plane do not count") {
  CHECK(norm(tangent_direction({0, 0, 3}, {0, 0, 1})) == 0);
  const Point d = tangent_direction({3, 4, 7}, {0, 0, 1});
  CHECK(d.x == doctest::Approx(0.6));
  CHECK(d.y == doctest::Approx(0.8));
  CHECK(d.z == 0);
}
