// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flip.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/random.h"
#include "mesh/insert.h"
#include "mesh/quality.h"

namespace rimline {
namespace {

// A bumpy height field over a lattice, cut along arbitrary diagonals.
struct Field {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

Field bumpy_field(int side, std::uint64_t seed) {
  Random random(seed);
  Field field;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double u = x + 0.6 * random.uniform(), v = y + 0.6 * random.uniform();
      field.points.push_back({u, v, std::sin(u) * std::cos(0.7 * v)});
    }
  }
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      const Index a = y * side + x, b = a + 1, c = a + side + 1, d = a + side;
      if (random.below(2) == 0) {
        field.triangles.insert(field.triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
      } else {
        field.triangles.insert(field.triangles.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
      }
    }
  }
  return field;
}

double angle(Point p, Point a, Point b) { return std::atan2(norm(cross(a - p, b - p)), dot(a - p, b - p)); }

// The neighbours that a triangulation names are right, and no edge is named twice in one direction.
void check_neighbours(const Triangulation& mesh) {
  std::set<std::pair<Index, Index>> directed;
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index from = mesh.triangles[t][next(c)], to = mesh.triangles[t][previous(c)];
      REQUIRE(directed.emplace(from, to).second);
      const Index other = mesh.adjacent[t][c];
      if (other == none) continue;
      const int d = mesh.corner_across(other, t);
      REQUIRE(mesh.adjacent[other][d] == t);
      REQUIRE(mesh.triangles[other][next(d)] == to);
      REQUIRE(mesh.triangles[other][previous(d)] == from);
    }
  }
}

std::set<std::pair<Index, Index>> boundary_of(const Triangulation& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (mesh.adjacent[t][c] == none)
        edges.emplace(mesh.triangles[t][next(c)], mesh.triangles[t][previous(c)]);
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("the long diagonal of a flat rhombus is flipped, the short one stays") {
  const std::vector<Point> points{{0, -1, 0}, {3, 0, 0}, {0, 1, 0}, {-3, 0, 0}};
  Triangulation mesh = triangulation_of({{1, 2, 3}, {3, 0, 1}}, 4);
  CHECK(flip_edges(points, mesh, {}) == 1);
  check_neighbours(mesh);
  for (const Triangle& t : mesh.triangles) {
    CHECK(std::count(t.begin(), t.end(), 0) + std::count(t.begin(), t.end(), 2) == 2);
  }
  CHECK(flip_edges(points, mesh, {}) == 0);
}

TEST_CASE("no flip makes two triangles face away from each other that did not") {
  // Random corners for which the angles ask for the flip.
  const std::vector<Point> points{
      {-0.53, 0.57, 0.57}, {1.06, -1.09, 0.01}, {1.78, -0.92, -0.13}, {-2.33, 1.65, -0.74}};
  const auto facing = [&](const Triangle& s, const Triangle& t) {
    return dot(cross(points[s[1]] - points[s[0]], points[s[2]] - points[s[0]]),
               cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  };
  REQUIRE(facing({0, 1, 3}, {2, 3, 1}) > 0);
  REQUIRE(facing({0, 1, 2}, {2, 3, 0}) < 0);
  Triangulation mesh = triangulation_of({{0, 1, 3}, {2, 3, 1}}, 4);
  CHECK(flip_edges(points, mesh, {}) == 0);
}

TEST_CASE("squares keep the diagonal they have") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Triangulation mesh = triangulation_of({{0, 1, 2}, {0, 2, 3}}, 4);
  CHECK(flip_edges(points, mesh, {}) == 0);
}

TEST_CASE("after the flips no two opposite angles sum to more than pi, the boundary is what it was") {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Field field = bumpy_field(20, seed);
    Triangulation mesh = triangulation_of(field.triangles, static_cast<Index>(field.points.size()));
    check_neighbours(mesh);
    const auto boundary = boundary_of(mesh);
    CHECK(flip_edges(field.points, mesh, {}) > 0);
    check_neighbours(mesh);
    CHECK(boundary_of(mesh) == boundary);
    for (Index t = 0; t < mesh.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        const Index other = mesh.adjacent[t][c];
        if (other == none) continue;
        const Triangle& v = mesh.triangles[t];
        const Point a = field.points[v[next(c)]], b = field.points[v[previous(c)]];
        const Point apex = field.points[mesh.triangles[other][mesh.corner_across(other, t)]];
        CHECK(angle(field.points[v[c]], a, b) + angle(apex, a, b) < std::numbers::pi + 1e-6);
      }
    }
  }
}

TEST_CASE("no flip makes an edge that exists: a flat pyramid keeps the three edges at its tip") {
  // The tip 3 has three neighbours; flipping one of its edges would join two corners of the base again.
  const std::vector<Point> points{{-1, 0, 0}, {1, 0, 0}, {0, 0.2, 0}, {0, 0.1, 0}};
  Triangulation mesh = triangulation_of({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 4);
  flip_edges(points, mesh, {});
  check_neighbours(mesh);
  CHECK(mesh.size() == 3);
}

TEST_CASE("a point that no triangle has is put into the nearest one") {
  const Field field = bumpy_field(8, 5);
  std::vector<Point> points = field.points;
  points.push_back({3.4, 3.3, 0.2});
  points.push_back({3.5, 3.3, 0.2});
  Triangulation mesh = triangulation_of(field.triangles, static_cast<Index>(points.size()));
  CHECK(insert_missing(points, find_neighbours(points, 8, {}), mesh).empty());
  check_neighbours(mesh);
  CHECK(mesh.triangles.size() == field.triangles.size() + 4);
  std::set<Index> used;
  for (const Triangle& t : mesh.triangles) used.insert(t.begin(), t.end());
  CHECK(used.size() == points.size());
}

TEST_CASE("long and folded edges are counted") {
  // Two triangles folded flat onto each other along one edge, that edge ten spacings long.
  const std::vector<Point> points{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}, {5, 1, 0.1}};
  const Triangulation folded = triangulation_of({{0, 1, 2}, {1, 0, 3}}, 4);
  CHECK(edge_quality(points, folded, std::vector<double>(4, 100.0)).bad == 1);
  CHECK(edge_quality(points, folded, std::vector<double>(4, 100.0)).length == doctest::Approx(10));
  const std::vector<Point> flat{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}, {5, -1, 0}};
  const Triangulation open = triangulation_of({{0, 1, 2}, {1, 0, 3}}, 4);
  CHECK(edge_quality(flat, open, std::vector<double>(4, 100.0)).bad == 0);
  CHECK(edge_quality(flat, open, std::vector<double>(4, 1.0)).bad == 1);
}

TEST_CASE("a large mesh, asked in parallel, ends as the flips one by one would end it") {
  const Field field = bumpy_field(60, 11);  // 6,962 triangles: above what is asked in parallel
  std::vector<Triangulation> meshes;
  for (const int threads : {1, 2}) {
    meshes.push_back(triangulation_of(field.triangles, static_cast<Index>(field.points.size())));
    flip_edges(field.points, meshes.back(), Run{.threads = threads});
  }
  CHECK(meshes[0].triangles == meshes[1].triangles);
  check_neighbours(meshes[0]);
  const Triangulation before = meshes[0];
  CHECK(flip_edges(field.points, meshes[0], Run{}) == 0);
  for (Index t = 0; t < before.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = before.adjacent[t][c];
      if (other == none) continue;
      const Triangle& v = before.triangles[t];
      const Point a = field.points[v[next(c)]], b = field.points[v[previous(c)]];
      const Index apex = before.triangles[other][before.corner_across(other, t)];
      CHECK(angle(field.points[v[c]], a, b) + angle(field.points[apex], a, b) < std::numbers::pi + 1e-6);
    }
  }
}

}  // namespace rimline
