// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/outliers.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "rimline/measure.h"
#include "rimline/refine_surface.h"

namespace rimline {
namespace {

// A lattice of side * side points in a plane, two triangles a square but for one in the middle that is a gap,
// and its border.
struct Lattice {
  static constexpr Index side = 11;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Loop> loops;

  static Index at(Index x, Index y) { return y * side + x; }

  Lattice() {
    for (Index y = 0; y < side; ++y) {
      for (Index x = 0; x < side; ++x) points.push_back({1.0 * x, 1.0 * y, 0.01 * ((7 * x + 3 * y) % 5)});
    }
    for (Index y = 0; y + 1 < side; ++y) {
      for (Index x = 0; x + 1 < side; ++x) {
        if (x == 5 && y == 5) continue;
        triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
        triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    }
    Loop border;
    for (Index i = 0; i + 1 < side; ++i) border.points.push_back(at(i, 0));
    for (Index i = 0; i + 1 < side; ++i) border.points.push_back(at(side - 1, i));
    for (Index i = side - 1; i > 0; --i) border.points.push_back(at(i, side - 1));
    for (Index i = side - 1; i > 0; --i) border.points.push_back(at(0, i));
    loops = {border};
  }

  Index add(Point p) {
    points.push_back(p);
    return static_cast<Index>(points.size()) - 1;
  }
};

}  // namespace

TEST_CASE("points beyond the loop are beside the surface, points in a gap of it are not") {
  Lattice lattice;
  lattice.add({5.4, 5.6, 0.02});
  const Index edge = lattice.add({4.5, -0.7, 0}), corner = lattice.add({10.6, 10.8, 0});
  const Neighbours neighbours = find_neighbours(lattice.points, 16, {});
  CHECK(points_beside(lattice.points, neighbours, lattice.loops, lattice.triangles) ==
        std::vector<Index>{edge, corner});
}

TEST_CASE("a scrap of surface that touches the rim in a point is beside it") {
  Lattice lattice;
  const Index a = lattice.add({4.3, -0.9, 0}), b = lattice.add({5.3, -0.9, 0});
  lattice.triangles.push_back({Lattice::at(5, 0), a, b});
  const Neighbours neighbours = find_neighbours(lattice.points, 16, {});
  CHECK(points_beside(lattice.points, neighbours, lattice.loops, lattice.triangles) ==
        std::vector<Index>{a, b});
}

TEST_CASE(
    "points beside the surface are left out where that is asked for, and the mesh does not meet itself") {
  Lattice lattice;
  const Index gap = lattice.add({5.4, 5.6, 0.02});
  std::vector<Index> beside;
  for (int i = 1; i < 9; ++i) beside.push_back(lattice.add({i + 0.4, -0.6, 0.05 * (i % 3)}));
  const Neighbours neighbours = find_neighbours(lattice.points, 16, {});
  RefineOptions options;
  options.leave_beside = true;
  const Surface surface =
      refine_surface(lattice.points, neighbours, lattice.loops, lattice.triangles, options, {});
  CHECK(surface.left_out == beside);
  for (const Index v : beside) CHECK(surface.patch[v] == none);
  CHECK(surface.patch[gap] == 0);
  CHECK(surface.triangles.size() ==
        2 * (lattice.points.size() - beside.size()) - 2 - 4 * (Lattice::side - 1));
  CHECK(find_self_intersections(lattice.points, surface.triangles, {}).empty());
}

}  // namespace rimline
