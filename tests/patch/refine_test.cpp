// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>

#include "map/embed.h"
#include "rimline/arrange.h"
#include "rimline/refine_surface.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

struct Case {
  Arrangement arrangement;
  Neighbours neighbours;
  std::vector<Loop> loops;
};

Case make_case(Shape shape, Sampling sampling, std::size_t n, const Run& run) {
  Sample s = sample({shape, sampling, n, 0}, run);
  Case c;
  c.arrangement = arrange(s.points, run);
  std::vector<Index> where(s.points.size(), none);
  for (std::size_t i = 0; i < c.arrangement.ids.size(); ++i)
    where[c.arrangement.ids[i]] = static_cast<Index>(i);
  c.loops = s.loops;
  for (Loop& loop : c.loops) {
    for (Index& id : loop.points) id = where[id];
  }
  c.neighbours = find_neighbours(c.arrangement.points, 24, run);
  return c;
}

std::set<std::pair<Index, Index>> edges_of(const std::vector<Loop>& loops) {
  std::set<std::pair<Index, Index>> edges;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      edges.emplace(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    }
  }
  return edges;
}

std::set<std::pair<Index, Index>> open_edges(const std::vector<Triangle>& triangles) {
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[c == 2 ? 0 : c + 1];
      if (edges.erase({b, a}) == 0) edges.emplace(a, b);
    }
  }
  return edges;
}

void check_patch(const Case& c, const Patch& patch) {
  const long long n = static_cast<long long>(c.arrangement.points.size());
  CHECK(open_edges(patch.triangles) == edges_of(c.loops));
  std::set<Index> used;
  for (const Triangle& t : patch.triangles) used.insert(t.begin(), t.end());
  CHECK(used.size() == c.arrangement.points.size());
  // V - E + F = 2 - loops, with E = (3 F + boundary) / 2.
  long long rim = 0;
  for (const Loop& loop : c.loops) rim += static_cast<long long>(loop.points.size());
  CHECK(2 * n - static_cast<long long>(patch.triangles.size()) - rim ==
        2 * (2 - static_cast<long long>(c.loops.size())));
  CHECK(patch.uv_flips == 0);
  CHECK(flipped_triangles(patch.triangles, patch.uv, {}).empty());
  CHECK(patch.map.residual <= 1e-10);
}

}  // namespace

TEST_CASE("the mesh uses every point, ends at the loops edge for edge, and its map has no flips") {
  const Run run;
  for (const Shape shape :
       {Shape::FlatDisc, Shape::BumpySquare, Shape::WavySaddle, Shape::HemisphereCap, Shape::SphereMinusCap,
        Shape::HalfTunnel, Shape::CurledStrip, Shape::Pipe, Shape::SquareWithHoles, Shape::CappedTube}) {
    for (const Sampling sampling : {Sampling::BlueNoise, Sampling::Random}) {
      CAPTURE(name(shape));
      CAPTURE(name(sampling));
      const Case c = make_case(shape, sampling, 2000, run);
      check_patch(c, refine_patch(c.arrangement.points, c.neighbours, c.loops, {}, run));
    }
  }
}

TEST_CASE("refinement leaves no long or folded edges on a clean surface") {
  const Run run;
  const Case c = make_case(Shape::SphereMinusCap, Sampling::BlueNoise, 3000, run);
  const Patch patch = refine_patch(c.arrangement.points, c.neighbours, c.loops, {}, run);
  REQUIRE_FALSE(patch.rounds.empty());
  CHECK(patch.rounds.back().bad_edges == 0);
}

TEST_CASE("the bytes of mesh and map do not depend on the number of threads") {
  std::vector<Patch> patches;
  for (const int threads : {1, 2}) {
    Run run;
    run.threads = threads;
    const Case c = make_case(Shape::HalfTunnel, Sampling::Random, 20000, run);
    patches.push_back(refine_patch(c.arrangement.points, c.neighbours, c.loops, {}, run));
  }
  CHECK(patches[0].triangles == patches[1].triangles);
  REQUIRE(patches[0].uv.size() == patches[1].uv.size());
  CHECK(std::memcmp(patches[0].uv.data(), patches[1].uv.data(), patches[0].uv.size() * sizeof(UV)) == 0);
}

TEST_CASE("a handle and a one-sided strip are recognized, whatever the sampling and the seed") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const Sampling sampling : {Sampling::BlueNoise, Sampling::Random}) {
      for (const Shape shape : {Shape::TorusMinusCap, Shape::MoebiusStrip}) {
        Run run;
        run.seed = seed;
        const Case c = make_case(shape, sampling, 2000, run);
        try {
          refine_patch(c.arrangement.points, c.neighbours, c.loops, {}, run);
          FAIL("nothing was thrown");
        } catch (const Error& error) {
          CHECK(error.code() == ErrorCode::NotADisc);
          const char* reason = shape == Shape::TorusMinusCap ? "1 handle" : "one-sided";
          CHECK(std::string(error.what()).find(reason) != std::string::npos);
        }
      }
    }
  }
}

TEST_CASE("points far from the loop's component are named as unreachable") {
  const Run run;
  Case c = make_case(Shape::FlatDisc, Sampling::BlueNoise, 500, run);
  std::vector<Point> points = c.arrangement.points;
  std::vector<Index> far;
  for (int i = 0; i < 40; ++i) {
    far.push_back(static_cast<Index>(points.size()));
    points.push_back({100 + 0.01 * (i % 7), 0.01 * static_cast<double>(i / 7), 0});
  }
  try {
    refine_patch(points, find_neighbours(points, 12, run), c.loops, {}, run);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::UnreachableInterior);
    CHECK(error.ids() == far);
  }
}

}  // namespace rimline
