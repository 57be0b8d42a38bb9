// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/open_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "grids.h"
#include "map/bisect.h"
#include "map/cut_graph.h"

namespace rimline {
namespace {

std::vector<OpenMesh> cut_along(const OpenMesh& open, const Cuts& cuts) {
  return open_parts(open, std::vector<Index>(open.mesh.triangles.size(), 0), cuts);
}

// Each vertex of the cut mesh lies where that of the surface lies, and each triangle has its corners.
void check_origin(const OpenMesh& open, const shapes::Mesh& surface) {
  for (Index v = 0; v < open.vertices(); ++v) CHECK(open.points[v] == surface.points[open.vertex[v]]);
  for (std::size_t t = 0; t < open.triangle.size(); ++t) {
    Triangle a = surface.triangles[open.triangle[t]], b;
    for (int c = 0; c < 3; ++c) b[c] = open.vertex[open.mesh.triangles[t][c]];
    std::ranges::sort(a);
    std::ranges::sort(b);
    CHECK(a == b);
  }
}

}  // namespace

TEST_CASE("handles and loops are counted: a torus, a sphere, a tube, a strip with a twist") {
  const shapes::Mesh torus = shapes::torus(24, 12, 3, 1), tube = shapes::tube(12, 5);
  const OpenMesh ring = open_surface(torus.points, torus.triangles);
  CHECK(ring.genus == 1);
  CHECK(ring.loops.empty());
  const OpenMesh pipe = open_surface(tube.points, tube.triangles);
  CHECK(pipe.genus == 0);
  CHECK(pipe.loops.size() == 2);
  const shapes::Mesh ball = shapes::octahedron(3);
  CHECK(open_surface(ball.points, ball.triangles).genus == 0);
  const shapes::Mesh strip = shapes::moebius(40, 4);
  const OpenMesh flat = open_surface(strip.points, strip.triangles);  // cut across
  CHECK(flat.loops.size() == 1);
  CHECK(flat.genus == 0);
  CHECK(flat.vertices() > static_cast<Index>(strip.points.size()));
  check_origin(flat, strip);
}

TEST_CASE("handles are cut along their shortest closed curves: those of a torus about and through its tube") {
  const shapes::Mesh torus = shapes::torus(48, 16, 3, 1);
  const OpenMesh ring = open_surface(torus.points, torus.triangles);
  const std::vector<OpenMesh> parts = cut_along(ring, cut_handles(ring));
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].genus == 0);
  REQUIRE(parts[0].loops.size() == 1);
  check_origin(parts[0], torus);
  // Twice each: 2 pi about the tube, and 2 pi 2 through the hole; along edges, which zigzag a little.
  const double shortest = 2 * (2 * std::numbers::pi + 4 * std::numbers::pi);
  CHECK(parts[0].loops[0].length > 0.97 * shortest);
  CHECK(parts[0].loops[0].length < 1.2 * shortest);
}

TEST_CASE("a slit opens a closed surface, and a tube between its rims") {
  const shapes::Mesh ball = shapes::octahedron(4);
  const OpenMesh closed = open_surface(ball.points, ball.triangles);
  const std::vector<OpenMesh> opened = cut_along(closed, slit(closed, 0, {}));
  REQUIRE(opened.size() == 1);
  CHECK(opened[0].loops.size() == 1);
  const shapes::Mesh tube = shapes::tube(12, 5);
  const OpenMesh pipe = open_surface(tube.points, tube.triangles);
  const std::vector<OpenMesh> strip =
      cut_along(pipe, slit(pipe, pipe.loops[1].points[0], pipe.loops[0].points));
  REQUIRE(strip.size() == 1);
  CHECK(strip[0].loops.size() == 1);
  check_origin(strip[0], tube);
}

TEST_CASE("a bisected dumbbell is cut at its neck") {
  const shapes::Mesh dumbbell = shapes::dumbbell(24, 60);
  const OpenMesh whole = open_surface(dumbbell.points, dumbbell.triangles);
  const std::vector<OpenMesh> parts =
      open_parts(whole, bisect(whole, 0), Cuts(whole.mesh.triangles.size(), {0, 0, 0}));
  REQUIRE(parts.size() == 2);
  for (const OpenMesh& part : parts) {
    // The cut is the shorter of its two loops.
    REQUIRE(part.loops.size() == 2);
    CHECK(part.loops[1].length < 1.3 * 2 * std::numbers::pi * shapes::neck);
  }
}

}  // namespace rimline
