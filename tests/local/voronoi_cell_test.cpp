// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/voronoi_cell.h"

#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <random>

namespace rimline {
namespace {

// Keeps what is nearer to the origin than to (x, y).
void cut(VoronoiCell& cell, double x, double y, Index id) { cell.cut(x, y, (x * x + y * y) / 2, id); }

// Length of each side over the distance of the neighbour beyond it.
std::map<Index, double> weights_of(const VoronoiCell& cell, const std::vector<UV>& points) {
  std::map<Index, double> weights;
  for (std::size_t side = 0; side < cell.sides().size(); ++side) {
    const Index id = cell.sides()[side];
    if (id != none) weights[id] += cell.side_length(side) / std::hypot(points[id].u, points[id].v);
  }
  return weights;
}

VoronoiCell cell_of(const std::vector<UV>& points, double half_width) {
  VoronoiCell cell;
  cell.reset(half_width);
  for (std::size_t i = 0; i < points.size(); ++i) cut(cell, points[i].u, points[i].v, static_cast<Index>(i));
  return cell;
}

}  // namespace

TEST_CASE("on a square lattice the four nearest have weight 1 and the diagonals none") {
  const std::vector<UV> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const VoronoiCell cell = cell_of(points, 10);
  REQUIRE(cell.is_closed());
  const std::map<Index, double> weights = weights_of(cell, points);
  for (Index i = 0; i < 4; ++i) CHECK(weights.at(i) == doctest::Approx(1));
  for (const auto& [i, weight] : weights) CHECK((i < 4 || weight < 1e-12));
}

TEST_CASE("in a hexagonal lattice all six weights are 1 / sqrt 3") {
  std::vector<UV> points;
  for (int i = 0; i < 6; ++i)
    points.push_back({std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)});
  const std::map<Index, double> weights = weights_of(cell_of(points, 10), points);
  for (Index i = 0; i < 6; ++i) CHECK(weights.at(i) == doctest::Approx(1 / std::sqrt(3.0)));
}

TEST_CASE("the weights of a closed cell reproduce linear functions") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int closed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<UV> points;
    for (int i = 0; i < 20; ++i) points.push_back({coordinate(random), coordinate(random)});
    const VoronoiCell cell = cell_of(points, 100);
    if (!cell.is_closed()) continue;
    ++closed;
    double u = 0, v = 0, size = 0;
    for (const auto& [i, weight] : weights_of(cell, points)) {
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
  cell.reset(1);
  CHECK_FALSE(cell.is_settled(2.8 * 2.8));  // the square's corners lie at sqrt 2
  CHECK(cell.is_settled(2.9 * 2.9));
  cut(cell, 0.5, 0, 7);
  CHECK_FALSE(cell.is_closed());
  CHECK(std::ranges::count(cell.sides(), 7) == 1);
}

TEST_CASE("a cell of more corners than fit in a word is cut the same way") {
  std::vector<UV> points;
  for (int i = 0; i < 100; ++i)
    points.push_back({std::cos(i * std::numbers::pi / 50), std::sin(i * std::numbers::pi / 50)});
  const VoronoiCell cell = cell_of(points, 10);
  CHECK(cell.is_closed());
  CHECK(cell.sides().size() == points.size());
}

}  // namespace rimline
