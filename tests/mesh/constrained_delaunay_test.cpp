// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/constrained_delaunay.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "base/random.h"

namespace rimline {
namespace {

Loop ring(Index first, Index count, bool backwards) {
  Loop loop;
  for (Index i = 0; i < count; ++i) loop.points.push_back(first + (backwards ? count - 1 - i : i));
  return loop;
}

void add_circle(std::vector<UV>& uv, UV centre, double radius, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    uv.push_back({centre.u + radius * std::cos(angle), centre.v + radius * std::sin(angle)});
  }
}

std::set<std::pair<Index, Index>> open_edges(const std::vector<Triangle>& triangles) {
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[next(c)];
      if (edges.erase({b, a}) == 0) edges.emplace(a, b);
    }
  }
  return edges;
}

double area(const std::vector<UV>& uv, const Triangle& t) {
  const UV a = uv[t[0]], b = uv[t[1]], c = uv[t[2]];
  return 0.5 * ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
}

}  // namespace

TEST_CASE("the boundary of the triangles is the loops, edge for edge, and holes stay open") {
  std::vector<UV> uv;
  add_circle(uv, {0, 0}, 1, 24);
  add_circle(uv, {0.3, 0.2}, 0.2, 9);
  add_circle(uv, {-0.4, -0.1}, 0.1, 5);
  Random random(4);
  while (uv.size() < 300) {
    const UV p{2 * random.uniform() - 1, 2 * random.uniform() - 1};
    const bool inside = std::hypot(p.u, p.v) < 0.95 && std::hypot(p.u - 0.3, p.v - 0.2) > 0.21 &&
                        std::hypot(p.u + 0.4, p.v + 0.1) > 0.11;
    if (inside) uv.push_back(p);
  }
  const std::vector<Loop> loops{ring(0, 24, false), ring(24, 9, true), ring(33, 5, true)};
  const std::vector<Triangle> triangles = constrained_delaunay(uv, loops);
  std::set<std::pair<Index, Index>> expected;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      expected.emplace(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    }
  }
  CHECK(open_edges(triangles) == expected);
  double sum = 0;
  for (const Triangle& t : triangles) {
    CHECK(area(uv, t) > 0);
    sum += area(uv, t);
  }
  const auto polygon = [](int n, double r) { return 0.5 * n * r * r * std::sin(6.283185307179586 / n); };
  CHECK(sum == doctest::Approx(polygon(24, 1) - polygon(9, 0.2) - polygon(5, 0.1)));
  // Euler: V - E + F = 1 - holes, with E = (3 F + boundary) / 2.
  CHECK(2 * 300 - static_cast<int>(triangles.size()) - 38 == 2 * (1 - 2));
}

TEST_CASE("loops that cross in the plane are named") {
  std::vector<UV> uv;
  add_circle(uv, {0, 0}, 1, 12);
  add_circle(uv, {0.2, 0}, 0.3, 8);
  add_circle(uv, {-0.1, 0}, 0.3, 8);
  try {
    constrained_delaunay(uv, {ring(0, 12, false), ring(12, 8, true), ring(20, 8, true)});
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::NotADisc);
    CHECK(error.ids().size() == 2);
    for (const Index id : error.ids()) CHECK(id >= 12);
  }
}

TEST_CASE("of points at one place only one is on triangles, and always the one of the loop") {
  std::vector<UV> uv;
  uv.push_back({1, 0});  // the same place as the first of the circle, with a lower id
  add_circle(uv, {0, 0}, 1, 8);
  uv.push_back({0.1, 0.1});
  uv.push_back({0.1, 0.1});
  const std::vector<Triangle> triangles = constrained_delaunay(uv, {ring(1, 8, false)});
  std::set<Index> used;
  for (const Triangle& t : triangles) used.insert(t.begin(), t.end());
  CHECK(used.count(0) == 0);
  CHECK(used.count(1) == 1);
  CHECK(used.count(9) + used.count(10) == 1);
}

}  // namespace rimline
