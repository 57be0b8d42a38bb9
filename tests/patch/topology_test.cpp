// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/topology.h"

#include <doctest/doctest.h>

#include "rimline/sample.h"

namespace rimline {
namespace {

Topology topology_of(Shape shape, std::uint64_t seed) {
  Run run;
  run.seed = seed;
  const Sample s = sample({shape, Sampling::Random, 1500, 0}, run);
  return find_topology(s.points, find_weighted_stars(s.points, find_neighbours(s.points, 24, run), run));
}

}  // namespace

TEST_CASE("discs, annuli and spheres have no handle and two sides") {
  for (const Shape shape : {Shape::FlatDisc, Shape::HalfTunnel, Shape::Pipe, Shape::SquareWithHoles,
                            Shape::CappedTube, Shape::CurledStrip, Shape::ClosedSphere}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      CAPTURE(name(shape));
      const Topology topology = topology_of(shape, seed);
      CHECK(topology.orientable);
      CHECK(topology.genus == 0);
      CHECK(topology.coverage > 0.99);
    }
  }
}

TEST_CASE("a torus minus a cap has one handle, a Moebius strip one side") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    CHECK(topology_of(Shape::TorusMinusCap, seed).genus == 1);
    CHECK(topology_of(Shape::TorusMinusCap, seed).orientable);
    CHECK_FALSE(topology_of(Shape::MoebiusStrip, seed).orientable);
  }
}

TEST_CASE(
    "folds tell nothing of sides: the projective plane on an octahedron's corners is not called one-sided") {
  const std::vector<Point> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::size_t> start{0};
  UnfilledVector<Index> ids;
  for (const std::vector<Index>& around : std::vector<std::vector<Index>>{{1, 2, 3, 5, 4},
                                                                          {0, 2, 5, 3, 4},
                                                                          {0, 1, 5, 4, 3},
                                                                          {0, 2, 4, 1, 5},
                                                                          {0, 1, 3, 2, 5},
                                                                          {0, 3, 1, 2, 4}}) {
    ids.insert(ids.end(), around.begin(), around.end());
    start.push_back(ids.size());
  }
  const Topology topology = find_topology(points, Stars(std::move(start), std::move(ids)));
  CHECK(topology.triangles == 10);
  CHECK(topology.coverage == 1);
  CHECK(topology.orientable);
}

}  // namespace rimline
