// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/measure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "base/union_find.h"
#include "mesh/edges.h"

namespace rimline {
namespace {

const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<double> unit_spacing(8, 1.0);

TEST_CASE("a square of two triangles: area 1, Euler number 1, one loop of four edges, no flips") {
  const std::vector<UV> uv{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const MeshSummary m = measure_mesh(square, {{0, 1, 2}, {0, 2, 3}}, unit_spacing, uv);
  CHECK(m.area == doctest::Approx(1));
  CHECK(m.euler == 1);
  CHECK(m.components == 1);
  CHECK(m.boundary_loops == 1);
  CHECK(m.boundary_edges == 4);
  CHECK(m.edges == 5);
  CHECK(m.uv_flips == 0);
  CHECK(m.mean_angle_distortion == doctest::Approx(0));
  CHECK(m.min_angle_histogram[9] + m.min_angle_histogram[8] == 2);  // 45 degrees, give or take a rounding
}

TEST_CASE("a tetrahedron is closed: Euler number 2 and no boundary") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const MeshSummary m = measure_mesh(points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, unit_spacing, {});
  CHECK(m.euler == 2);
  CHECK(m.boundary_loops == 0);
  CHECK(m.nonmanifold_vertices == 0);
}

TEST_CASE("three triangles at one edge and two fans at one vertex are counted") {
  const std::vector<Point> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {0, -1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const std::vector<double> spacing(7, 1.0);
  CHECK(measure_mesh(points, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, spacing, {}).nonmanifold_edges == 1);
  CHECK(measure_mesh(points, {{0, 1, 2}, {0, 5, 6}}, spacing, {}).nonmanifold_vertices == 1);
}

TEST_CASE("a folded map counts its smaller side as flipped") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}};
  const std::vector<UV> uv{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  const MeshSummary m = measure_mesh(points, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}, unit_spacing, uv);
  CHECK(m.uv_flips == 1);
}

TEST_CASE("inner edges longer than three spacings are counted, boundary edges are not") {
  const std::vector<Point> points{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}, {5, -1, 0}};
  const MeshSummary m = measure_mesh(points, {{0, 1, 2}, {0, 3, 1}}, unit_spacing, {});
  CHECK(m.long_edges == 1);
}

TEST_CASE("edges come once each, ascending, with their triangles counted") {
  const auto edges = edges_of({{0, 1, 2}, {0, 2, 3}});
  REQUIRE(edges.size() == 5);
  CHECK(edges[1].a == 0);
  CHECK(edges[1].b == 2);
  CHECK(edges[1].triangles == 2);
  CHECK(edges[0].triangles == 1);
}

TEST_CASE("the counts of random triangles are those of their sorted edges, for any number of threads") {
  std::mt19937 random(5);
  const Index n = 20'000;  // more than one slice
  std::vector<Point> points(n);
  for (Point& p : points) p = {random() % 100 / 10.0, random() % 100 / 10.0, random() % 100 / 10.0};
  std::vector<Triangle> triangles;
  while (triangles.size() < 30'000) {  // ids close to each other, so that edges meet
    const Index a = random() % (n - 4), b = a + 1 + random() % 3;
    if (b != a + 2) triangles.push_back({a, b, a + 2});
  }
  const std::vector<double> spacing(n, 1.0);
  MeshSummary expected;
  std::size_t joins = 0;
  UnionFind pieces(n);
  std::set<Index> rim;
  for (const Edge& e : edges_of(triangles)) {
    ++expected.edges;
    expected.boundary_edges += e.triangles == 1;
    expected.nonmanifold_edges += e.triangles > 2;
    expected.long_edges += e.triangles == 2 && distance(points[e.a], points[e.b]) > 3;
    if (e.triangles != 1) continue;
    rim.insert({e.a, e.b});
    joins += pieces.join(e.a, e.b);
  }
  for (const int threads : {1, 2}) {
    const MeshSummary m =
        measure_mesh(points, triangles, spacing, {},
                     Run{.seed = 1, .threads = threads, .on_progress = {}, .stop = nullptr});
    CHECK(m.edges == expected.edges);
    CHECK(m.boundary_edges == expected.boundary_edges);
    CHECK(m.nonmanifold_edges == expected.nonmanifold_edges);
    CHECK(m.long_edges == expected.long_edges);
    CHECK(m.boundary_loops == rim.size() - joins);
  }
}

TEST_CASE("spacing is summed up by mean, ends and quantiles") {
  std::vector<double> spacing(101);
  std::iota(spacing.begin(), spacing.end(), 0.0);
  const SpacingSummary s = summarize_spacing(spacing);
  CHECK(s.mean == doctest::Approx(50));
  CHECK(s.least == 0);
  CHECK(s.most == 100);
  CHECK(s.low == 5);
  CHECK(s.high == 95);
}

}  // namespace
}  // namespace rimline
