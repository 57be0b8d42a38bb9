// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/voronoi_cell.h"

#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <random>

namespace rimline {
namespace {

std::map<Index, double> weights_of(const VoronoiCell& cell) {
  std::map<Index, double> weights;
  cell.edges([&](Index id, double weight) {
    if (id != none) weights[id] += weight;
  });
  return weights;
}

}  // namespace

TEST_CASE("on a square lattice the four nearest have weight 1 and the diagonals none") {
  VoronoiCell cell;
  cell.start(10);
  Index id = 0;
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    cell.clip(x, y, id++);
  }
  REQUIRE(cell.closed());
  const std::map<Index, double> weights = weights_of(cell);
  for (Index i = 0; i < 4; ++i) CHECK(weights.at(i) == doctest::Approx(1));
  for (const auto& [i, weight] : weights) CHECK((i < 4 || weight < 1e-12));
}

TEST_CASE("in a hexagonal lattice all six weights are 1 / sqrt 3") {
  VoronoiCell cell;
  cell.start(10);
  for (Index i = 0; i < 6; ++i)
    cell.clip(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), i);
  for (Index i = 0; i < 6; ++i) CHECK(weights_of(cell).at(i) == doctest::Approx(1 / std::sqrt(3.0)));
}

TEST_CASE("the weights of a closed cell reproduce linear functions") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int closed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    VoronoiCell cell;
    cell.start(100);
    std::vector<UV> points;
    for (Index i = 0; i < 20; ++i) {
      points.push_back({coordinate(random), coordinate(random)});
      cell.clip(points.back().u, points.back().v, i);
    }
    if (!cell.closed()) continue;
    ++closed;
    double u = 0, v = 0, size = 0;
    for (const auto& [i, weight] : weights_of(cell)) {
      u += weight * points[i].u;
      v += weight * points[i].v;
      size += weight;
    }
    CHECK(std::abs(u) < 1e-9 * size);
    CHECK(std::abs(v) < 1e-9 * size);
  }
  CHECK(closed > 150);
}

TEST_CASE("a cell with neighbours on one side only stays open, and is settled beyond twice its radius") {
  VoronoiCell cell;
  cell.start(1);
  CHECK_FALSE(cell.settled(2.8));  // the square's corners lie at sqrt 2
  CHECK(cell.settled(2.9));
  cell.clip(0.5, 0, 7);
  CHECK_FALSE(cell.closed());
  CHECK(weights_of(cell).count(7) == 1);
}

}  // namespace rimline
