// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/conformal_descent.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "map/conformal_scale.h"
#include "map/embed.h"
#include "map/free_chart.h"
#include "map/free_map.h"
#include "map/outline_crossings.h"
#include "rimline/refine_surface.h"

namespace rimline {
namespace {

struct Strip {
  std::vector<Point> points;
  Triangulation mesh;
  std::vector<Loop> loops;
};

// A strip that winds about the axis, rising a little: laid flat it lies over itself where it turns more than
// once.
Strip make_winding(double turns) {
  constexpr int across = 5;
  const int along = static_cast<int>(40 * turns);
  Strip strip;
  std::vector<Triangle> triangles;
  for (int i = 0; i <= along; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / along;
    for (int j = 0; j < across; ++j) {
      const double radius = 3 + 0.4 * j;
      strip.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.2 * angle});
    }
  }
  for (Index i = 0; i < along; ++i) {
    for (Index j = 0; j + 1 < across; ++j) {
      const Index a = i * across + j;
      triangles.push_back({a, a + 1, a + across + 1});
      triangles.push_back({a, a + across + 1, a + across});
    }
  }
  strip.mesh = triangulation_of(triangles, static_cast<Index>(strip.points.size()));
  Loop loop;
  for (Index j = 0; j < across; ++j) loop.points.push_back(j);
  for (Index i = 1; i <= along; ++i) loop.points.push_back(i * across + across - 1);
  for (Index j = across - 2; j >= 0; --j) loop.points.push_back(along * across + j);
  for (Index i = along - 1; i > 0; --i) loop.points.push_back(i * across);
  strip.loops = {loop};
  return strip;
}

Patch patch_of(const Strip& strip, Domain domain) {
  RefineOptions options;
  options.domain = domain;
  return refine_patch(strip.points, find_neighbours(strip.points, 20, {}), strip.loops, options, {});
}

}  // namespace

TEST_CASE("a strip that would lie over itself is laid beside itself, with little distortion") {
  const Strip strip = make_winding(1.4);
  std::vector<UV> overlapping;
  free_map(strip.points, strip.mesh, strip.loops[0].points, 0, overlapping, {});
  REQUIRE_FALSE(crossing_points(strip.loops, overlapping).empty());

  const Patch patch = patch_of(strip, Domain::Free);
  CHECK(patch.domain == Domain::Free);
  CHECK(patch.uv_flips == 0);
  CHECK(flipped_triangles(patch.triangles, patch.uv, {}).empty());
  CHECK(crossing_points(strip.loops, patch.uv).empty());
  const Triangulation mesh = triangulation_of(patch.triangles, static_cast<Index>(strip.points.size()));
  CHECK(conformal_distortion(strip.points, mesh, patch.uv) < 1.02);
}

TEST_CASE("a descent from the disc ends where least squares do, where these do not cross") {
  const Strip strip = make_winding(0.6);
  std::vector<UV> straight;
  free_map(strip.points, strip.mesh, strip.loops[0].points, 0, straight, {});
  REQUIRE(crossing_points(strip.loops, straight).empty());
  const Patch disc = patch_of(strip, Domain::Disc);
  const Triangulation mesh = triangulation_of(disc.triangles, static_cast<Index>(strip.points.size()));
  std::vector<UV> uv = disc.uv;
  CHECK(conformal_distortion(strip.points, mesh, uv) > 1.1);
  CHECK(relax_conformally(strip.points, mesh, strip.loops, {}, uv, {}) > 0);
  CHECK(conformal_distortion(strip.points, mesh, uv) < 1.001);
  CHECK(flipped_triangles(disc.triangles, uv, {}).empty());
}

TEST_CASE(
    "lengths are kept where they weigh: the disc's map of a strip, which is squeezed at its ends, is "
    "evened") {
  const Strip strip = make_winding(0.6);
  const OpenMesh open = open_surface(strip.points, strip.mesh.triangles);
  std::vector<UV> uv = disc_chart(open, 1e-10, {})->uv;
  CHECK(stretch_of_map(open, uv).mean > 2);
  CHECK(relax_conformally(open.points, open.mesh, open.loops, {.isometry = 1, .most_steps = 100}, uv, {}) >
        0);
  CHECK(stretch_of_map(open, uv).worst < 1.2);
  CHECK(flipped_triangles(open.mesh.triangles, uv, {}).empty());
  CHECK(crossing_points(open.loops, uv).empty());
  std::vector<UV> few = disc_chart(open, 1e-10, {})->uv;
  CHECK(relax_conformally(open.points, open.mesh, open.loops, {.isometry = 1, .most_steps = 2}, few, {}) ==
        2);
}

TEST_CASE("a surface without area is left as it is") {
  const std::vector<Point> points(3, Point{1, 2, 3});
  const Triangulation mesh = triangulation_of({{0, 1, 2}}, 3);
  Loop loop;
  loop.points = {0, 1, 2};
  std::vector<UV> uv{{0, 0}, {1, 0}, {0, 1}};
  CHECK(conformal_distortion(points, mesh, uv) == 1);
  CHECK(relax_conformally(points, mesh, {loop}, {}, uv, {}) == 0);
}

TEST_CASE("a map with a triangle turned over is left as it is") {
  const Strip strip = make_winding(0.5);
  std::vector<UV> uv;
  free_map(strip.points, strip.mesh, strip.loops[0].points, 0, uv, {});
  uv[7] = {uv[7].u + 100, uv[7].v};
  const std::vector<UV> before = uv;
  CHECK(relax_conformally(strip.points, strip.mesh, strip.loops, {}, uv, {}) == 0);
  CHECK(uv == before);
}

TEST_CASE("steps are fewer for larger meshes, so that their work is bounded") {
  CHECK(most_descent_steps(0) == 100);
  CHECK(most_descent_steps(4'000) == 100);
  CHECK(most_descent_steps(78'000) == 5);
  CHECK(most_descent_steps(10'000'000) == 5);
  for (std::size_t n = 1'000; n < 200'000; n += 500) {
    CHECK(most_descent_steps(n + 500) <= most_descent_steps(n));
    CHECK(most_descent_steps(n) * n <= std::max<std::size_t>(450'000, 5 * n));
  }
}

}  // namespace rimline
