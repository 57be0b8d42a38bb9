// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/refine_surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <thread>

#include "mesh_rules.h"
#include "patch/pinches.h"
#include "patch/topology.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

using Edges = std::set<std::pair<Index, Index>>;

Edges edges_of(const std::vector<Loop>& loops) {
  Edges edges;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      edges.emplace(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    }
  }
  return edges;
}

// Directed edges without their opposite; none may occur twice.
Edges open_edges(const std::vector<Triangle>& triangles) {
  Edges all;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) REQUIRE(all.emplace(t[c], t[c == 2 ? 0 : c + 1]).second);
  }
  Edges open;
  for (const auto& [a, b] : all) {
    if (all.count({b, a}) == 0) open.emplace(a, b);
  }
  return open;
}

// A bumpy sheet of side * side points, not quite regular.
std::vector<Point> sheet(int side, Point offset) {
  std::vector<Point> points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      points.push_back(offset + Point{x + 0.1 * std::sin(3.0 * x + y), y + 0.1 * std::cos(2.0 * y - x),
                                      0.2 * std::sin(x + 0.5 * y)});
    }
  }
  return points;
}

Loop border(int side, Index first) {
  Loop loop;
  for (Index i = 0; i + 1 < side; ++i) loop.points.push_back(first + i);
  for (Index i = 0; i + 1 < side; ++i) loop.points.push_back(first + side - 1 + i * side);
  for (Index i = side - 1; i > 0; --i) loop.points.push_back(first + (side - 1) * side + i);
  for (Index i = side - 1; i > 0; --i) loop.points.push_back(first + i * side);
  return loop;
}

// The rim of a hole over the lattice squares from (x, y) to (x + size, y + size), whose inner points must be
// few: clockwise, the surface on its left.
Loop square_hole(int side, Index x, Index y, Index size) {
  Loop loop;
  loop.kind = LoopKind::Hole;
  const auto id = [&](Index u, Index v) { return v * side + u; };
  for (Index i = 0; i < size; ++i) loop.points.push_back(id(x, y + i));
  for (Index i = 0; i < size; ++i) loop.points.push_back(id(x + i, y + size));
  for (Index i = size; i > 0; --i) loop.points.push_back(id(x + size, y + i));
  for (Index i = size; i > 0; --i) loop.points.push_back(id(x + i, y));
  return loop;
}

}  // namespace

TEST_CASE("two sheets become two patches, side by side in uv") {
  std::vector<Point> points = sheet(12, {0, 0, 0});
  const std::vector<Point> other = sheet(9, {30, 0, 0});
  points.insert(points.end(), other.begin(), other.end());
  const std::vector<Loop> loops{border(12, 0), border(9, 144)};
  const Run run;
  const Surface surface = refine_surface(points, find_neighbours(points, 20, run), loops, {}, {}, run);
  REQUIRE(surface.patches.size() == 2);
  CHECK(surface.left_out.empty());
  CHECK(open_edges(surface.triangles) == edges_of(loops));
  double most = -10, least = 10;
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(surface.patch[i] == (i < 144 ? 0 : 1));
    if (i < 144) most = std::max(most, surface.uv[i].u);
    if (i >= 144) least = std::min(least, surface.uv[i].u);
  }
  CHECK(most < least);
}

TEST_CASE(
    "many patches on any number of threads are the same surface, progress told by the caller's thread") {
  std::vector<Point> points;
  std::vector<Loop> loops;
  for (int k = 0; k < 70; ++k) {
    const int side = 5 + k % 7;
    loops.push_back(border(side, static_cast<Index>(points.size())));
    for (const Point& p : sheet(side, {20.0 * (k % 10), 20.0 * (k / 10), 0})) points.push_back(p);
  }
  Run run;
  run.threads = 1;
  const Neighbours neighbours = find_neighbours(points, 20, run);
  const Surface one = refine_surface(points, neighbours, loops, {}, {}, run);
  CHECK(one.patches.size() == 70);
  std::size_t calls = 0;
  run.threads = 4;
  run.on_progress = [&, caller = std::this_thread::get_id()](Progress) {
    CHECK(std::this_thread::get_id() == caller);
    ++calls;
  };
  const Surface four = refine_surface(points, neighbours, loops, {}, {}, run);
  CHECK(calls > 1);
  CHECK(four.triangles == one.triangles);
  CHECK(four.uv == one.uv);
  CHECK(four.patch == one.patch);
}

TEST_CASE("two sheets that go through each other in one point are two patches") {
  constexpr int side = 9;
  std::vector<Point> points = sheet(side, {0, 0, 0});
  std::vector<Loop> loops{border(side, 0), border(side, side * side)};
  for (const Point& p : sheet(side, {0, 0, 0})) points.push_back({p.x, 4 + p.z, p.y - 4});  // upright
  constexpr Index middle = side * side / 2, upright = side * side;
  std::vector<Triangle> triangles;
  for (const Index first : {0, upright}) {
    for (Index y = 0; y + 1 < side; ++y) {
      for (Index x = 0; x + 1 < side; ++x) {
        const Index a = first + y * side + x;
        triangles.push_back({a, a + 1, a + side + 1});
        triangles.push_back({a, a + side + 1, a + side});
      }
    }
  }
  // Both have the middle one; the other sheet's own is gone.
  for (Triangle& t : triangles) {
    for (Index& v : t) v = v == upright + middle ? middle : v > upright + middle ? v - 1 : v;
  }
  for (Index& v : loops[1].points) v -= v > upright + middle;
  points.erase(points.begin() + upright + middle);
  const Surface surface = refine_surface(points, find_neighbours(points, 20, {}), loops, triangles, {}, {});
  REQUIRE(surface.patches.size() == 2);
  CHECK(surface.left_out.empty());
  for (Index v = 0; v < static_cast<Index>(points.size()); ++v) {
    if (v != middle) CHECK(surface.patch[v] == (v < upright ? 0 : 1));
  }
  CHECK(open_edges(surface.triangles) == edges_of(loops));
}

TEST_CASE("points that hang together with no loop are left out and named") {
  std::vector<Point> points = sheet(10, {0, 0, 0});
  for (const Point& p : sheet(5, {40, 0, 0})) points.push_back(p);
  const Run run;
  const Surface surface =
      refine_surface(points, find_neighbours(points, 16, run), {border(10, 0)}, {}, {}, run);
  REQUIRE(surface.left_out.size() == 25);
  CHECK(surface.left_out.front() == 100);
  CHECK(std::isnan(surface.uv[110].u));
  CHECK(surface.patch[110] == none);
}

TEST_CASE(
    "where holes touch each other or the outline, the mesh is a manifold that ends at loops of its own") {
  const std::vector<Point> points = sheet(14, {0, 0, 0});
  const Run run;
  for (const bool at_outline : {false, true}) {
    CAPTURE(at_outline);
    std::vector<Loop> loops{border(14, 0), square_hole(14, 4, 4, 1), square_hole(14, 5, 5, 1)};
    if (at_outline) {  // a diamond that has its lowest corner on the border
      loops.pop_back();
      Loop diamond;
      diamond.kind = LoopKind::Hole;
      diamond.points = {10, 14 + 9, 28 + 10, 14 + 11};
      loops.push_back(diamond);
    }
    std::vector<Point> kept = points;
    if (at_outline) kept[14 + 10] = {10, -3, 9};  // the diamond's centre is no point of the sheet
    const Surface surface = refine_surface(kept, find_neighbours(kept, 20, run), loops, {}, {}, run);
    CHECK(test::broken_rule(surface.triangles, static_cast<int>(kept.size())) == "");
    CHECK(open_edges(surface.triangles) == edges_of(surface.loops));
  }
}

TEST_CASE(
    "where loops touch, the outline runs from one into the other and a copy stands for the second pass") {
  Loop outer, hole;
  outer.points = {0, 1, 2, 3, 4};
  hole.points = {7, 2, 6};
  hole.kind = LoopKind::Hole;
  const Separated separated = separate_pinches({outer, hole}, 10);
  REQUIRE(separated.loops.size() == 1);
  CHECK(separated.original == std::vector<Index>{2});
  CHECK(separated.loops[0].points == std::vector<Index>{0, 1, 2, 6, 7, 10, 3, 4});
  CHECK(separated.loops[0].kind == LoopKind::Outer);
  hole.kind = LoopKind::Outer;
  const Separated lobes = separate_pinches({outer, hole}, 10);
  REQUIRE(lobes.loops.size() == 2);
  CHECK(lobes.loops[0].points == outer.points);
  CHECK(lobes.loops[1].points == std::vector<Index>{7, 10, 6});
}

TEST_CASE("a sheet keeps its map beside a one-sided strip and a sphere, which are meshed without one") {
  std::vector<Point> points = sheet(10, {100, 0, 0});
  const Run run;
  std::vector<Loop> loops{border(10, 0)};
  for (const Shape shape : {Shape::MoebiusStrip, Shape::ClosedSphere}) {
    const Sample more = sample({shape, Sampling::BlueNoise, 1500, 0}, run);
    const auto first = static_cast<Index>(points.size());
    const double right = shape == Shape::ClosedSphere ? 50 : 0;
    for (const Point& p : more.points) points.push_back(p + Point{right, 0, 0});
    for (Loop loop : more.loops) {
      for (Index& v : loop.points) v += first;
      loops.push_back(loop);
    }
  }
  const Neighbours neighbours = find_neighbours(points, 24, run);
  const std::vector<Triangle> triangles = agreed_triangles(find_weighted_stars(points, neighbours, run));
  const Surface surface = refine_surface(points, neighbours, loops, triangles, {}, run);
  REQUIRE(surface.patches.size() == 3);
  CHECK(test::broken_rule(surface.triangles, static_cast<int>(points.size()), false) == "");
  CHECK(test::rim_of(surface.triangles).size() == loops[0].points.size() + loops[1].points.size());
  for (const PatchReport& patch : surface.patches) {
    CHECK(patch.failure.empty());
    const bool is_sheet = patch.points == 100, is_sphere = patch.loops == 0;
    CHECK(patch.domain == (is_sheet ? Domain::Disc : Domain::None));
    CHECK(patch.orientable == (is_sheet || is_sphere));
    CHECK(patch.genus == (is_sheet || is_sphere ? 0 : 1));
  }
  CHECK(std::isfinite(surface.uv[0].u));
  CHECK(std::isnan(surface.uv[points.size() - 1].u));
}

TEST_CASE("holes within the bound are filled, the others stay, and the map covers the fills") {
  const int side = 20;
  std::vector<Point> points = sheet(side, {0, 0, 0});
  const std::vector<Loop> loops{border(side, 0), square_hole(side, 3, 3, 1), square_hole(side, 9, 9, 2)};
  points[10 * side + 10] = {10, 10, 40};  // the middle of the larger hole is no point of the sheet
  const Run run;
  const Neighbours neighbours = find_neighbours(points, 20, run);
  for (const Domain domain : {Domain::Disc, Domain::Square, Domain::Free}) {
    for (const std::int64_t most : {4, 100}) {
      for (const bool with_points : {false, true}) {
        RefineOptions options;
        options.domain = domain;
        options.holes = {.fill = true, .most_points = most};
        options.fill_points = with_points;
        const Surface surface = refine_surface(points, neighbours, loops, {}, options, run);
        REQUIRE(surface.patches.size() == 1);
        std::vector<Loop> stay{loops[0]};
        if (most == 4) stay.push_back(loops[2]);
        CHECK(open_edges(surface.triangles) == edges_of(stay));
        CHECK(surface.patches[0].fills.size() == (most == 4 ? 1 : 2));
        CHECK(surface.patches[0].uv_flips == 0);
        CHECK(surface.uv.size() == points.size() + surface.added.size());
        CHECK(surface.filled.size() == surface.triangles.size());
        std::size_t filled = 0;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
          if (!surface.filled[t]) continue;
          ++filled;
          for (const Index v : surface.triangles[t]) {
            CHECK(std::isfinite(surface.uv[v].u));
            CHECK(surface.patch[v] == 0);
          }
        }
        CHECK(filled == surface.patches[0].fills[0].triangles +
                            (most == 4 ? 0 : surface.patches[0].fills[1].triangles));
      }
    }
  }
}

TEST_CASE("corners are taken in the order of the loop from the first, and must lie on one outer loop") {
  const std::vector<Point> points = sheet(10, {0, 0, 0});
  const Run run;
  const Neighbours neighbours = find_neighbours(points, 16, run);
  RefineOptions options;
  options.domain = Domain::Square;
  options.corners = {99, 0, 9, 90};
  const Surface surface = refine_surface(points, neighbours, {border(10, 0)}, {}, options, run);
  const auto at = [&](Index v) { return std::pair(surface.uv[v].u, surface.uv[v].v); };
  CHECK(at(99) == std::pair(0.0, 0.0));
  CHECK(at(90) == std::pair(1.0, 0.0));
  CHECK(at(0) == std::pair(1.0, 1.0));
  CHECK(at(9) == std::pair(0.0, 1.0));
  options.corners = {99, 0, 9, 55};
  CHECK_THROWS_AS(refine_surface(points, neighbours, {border(10, 0)}, {}, options, run), Error);
}

}  // namespace rimline
