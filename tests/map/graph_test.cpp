// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/graph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "map/weights.h"

namespace rimline {
namespace {

struct Lattice {
  int side;
  std::vector<Point> points;
  std::vector<char> rim;
};

Lattice flat_lattice(int side, double jitter) {
  Lattice lattice{side, {}, {}};
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool rim = x == 0 || y == 0 || x == side - 1 || y == side - 1;
      lattice.rim.push_back(rim);
      lattice.points.push_back({x + (rim ? 0 : shift(random)), y + (rim ? 0 : shift(random)), 2.5});
    }
  }
  return lattice;
}

}  // namespace

TEST_CASE("edges named twice add up, and rows ascend") {
  const Graph graph = make_graph(4, {{2, 0, 1}, {0, 1, 2}, {0, 2, 0.5}, {3, 2, 4}});
  CHECK(graph.offsets == std::vector<Index>{0, 2, 3, 5, 6});
  CHECK(graph.neighbours == std::vector<Index>{1, 2, 0, 0, 3, 2});
  CHECK(graph.weights == std::vector<double>{2, 1.5, 2, 1.5, 4, 4});
}

TEST_CASE("interior points without a path to the loop are named before any solve") {
  const Graph graph = make_graph(6, {{0, 1, 1}, {1, 2, 1}, {3, 4, 1}, {4, 5, 1}});
  const std::vector<char> fixed{1, 0, 0, 0, 0, 0};
  CHECK(unreachable(graph, fixed) == std::vector<Index>{3, 4, 5});
  std::vector<UV> uv(6);
  try {
    solve_map(graph, fixed, 1e-10, uv, {});
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::UnreachableInterior);
    CHECK(error.ids() == std::vector<Index>{3, 4, 5});
  }
}

TEST_CASE("every interior node is the weighted mean of its neighbours") {
  std::mt19937_64 random(11);
  std::vector<WeightedEdge> edges;
  for (Index i = 1; i < 500; ++i) {
    edges.push_back({i, static_cast<Index>(random() % i), 0.1 + static_cast<double>(random() % 100)});
    edges.push_back({i, static_cast<Index>(random() % i), 0.1 + static_cast<double>(random() % 100)});
  }
  std::erase_if(edges, [](const WeightedEdge& e) { return e.a == e.b; });
  const Graph graph = make_graph(500, edges);
  std::vector<char> fixed(500, 0);
  std::vector<UV> uv(500);
  for (Index i = 0; i < 10; ++i) {
    fixed[i] = 1;
    uv[i] = {std::cos(i), std::sin(i)};
  }
  const MapSummary summary = solve_map(graph, fixed, 1e-12, uv, {});
  CHECK(summary.unknowns == 490);
  CHECK(summary.residual <= 1e-11);
  for (Index i = 10; i < 500; ++i) {
    double u = 0, v = 0, sum = 0;
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      u += graph.weights[e] * uv[graph.neighbours[e]].u;
      v += graph.weights[e] * uv[graph.neighbours[e]].v;
      sum += graph.weights[e];
    }
    CHECK(std::abs(u / sum - uv[i].u) < 1e-8);
    CHECK(std::abs(v / sum - uv[i].v) < 1e-8);
  }
}

TEST_CASE("on an uneven flat sheet the map with local Voronoi weights is the sheet itself") {
  const Lattice lattice = flat_lattice(25, 0.35);
  const Run run;
  const Neighbours neighbours = find_neighbours(lattice.points, 24, run);
  const Stars stars = find_weighted_stars(lattice.points, neighbours, run);
  std::vector<UV> uv(lattice.points.size());
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (lattice.rim[i]) uv[i] = {lattice.points[i].x, lattice.points[i].y};
  }
  solve_map(make_graph(static_cast<Index>(uv.size()), star_edges(stars)), lattice.rim, 1e-12, uv, run);
  // Exact but for the open cells at the rim, which see half of their neighbours.
  double worst = 0;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    worst = std::max(worst, std::hypot(uv[i].u - lattice.points[i].x, uv[i].v - lattice.points[i].y));
  }
  CHECK(worst < 0.1);
}

TEST_CASE("neighbours behind the tangent plane are on another sheet and not in the star") {
  Lattice lower = flat_lattice(15, 0.2);
  std::vector<Point> points = lower.points;
  for (const Point& p : lower.points) points.push_back({p.x + 0.3, p.y + 0.2, p.z + 2.2});
  const Run run;
  const Stars stars = find_weighted_stars(points, find_neighbours(points, 30, run), run);
  const Index sheet = static_cast<Index>(lower.points.size());
  for (Index i = 0; i < 2 * sheet; ++i) {
    const Index x = i % sheet % lower.side, y = i % sheet / lower.side;
    if (std::min({x, y, lower.side - 1 - x, lower.side - 1 - y}) < 2) continue;  // open or nearly so
    for (const Index j : stars[i]) CHECK((i < sheet) == (j < sheet));
  }
}

TEST_CASE("islands are joined weakly to what lies beside them, and what has nothing beside it is left") {
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i) points.push_back({1.0 * i, 0.1 * (i % 2), 0});
  const Neighbours neighbours = find_neighbours(points, 3, {});
  std::vector<char> fixed(12, 0);
  fixed[0] = 1;
  std::vector<WeightedEdge> edges{{0, 1, 1}, {3, 4, 1}};  // everything else is an island
  join_islands(neighbours, fixed, edges);
  CHECK(unreachable(make_graph(12, edges), fixed).empty());
}

}  // namespace rimline
