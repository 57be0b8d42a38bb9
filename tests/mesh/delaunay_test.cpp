// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"

namespace rimline {
namespace {

double orientation(UV a, UV b, UV c) { return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u); }

// Positive where p lies inside the circle through a, b, c (counter-clockwise).
double in_circle(UV a, UV b, UV c, UV p) {
  const auto lift = [p](UV q) {
    const double du = q.u - p.u, dv = q.v - p.v;
    return std::array<double, 3>{du, dv, du * du + dv * dv};
  };
  const auto x = lift(a), y = lift(b), z = lift(c);
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

std::vector<UV> random_uv(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<UV> uv(count);
  for (UV& p : uv) p = {random.uniform(), random.uniform()};
  return uv;
}

TEST_CASE("every circumcircle is empty and every triangle counter-clockwise") {
  const auto uv = random_uv(200, 4);
  const auto triangles = delaunay(uv, {});
  CHECK(triangles.size() > 300);
  for (const auto& [a, b, c] : triangles) {
    CHECK(orientation(uv[a], uv[b], uv[c]) > 0);
    for (Index p = 0; p < 200; ++p) {
      if (p != a && p != b && p != c) CHECK(in_circle(uv[a], uv[b], uv[c], uv[p]) < 1e-12);
    }
  }
}

TEST_CASE("triangles ascend and each starts with its least id") {
  const auto triangles = delaunay(random_uv(500, 5), {});
  CHECK(std::is_sorted(triangles.begin(), triangles.end()));
  for (const auto& t : triangles) CHECK(t[0] == std::min({t[0], t[1], t[2]}));
}

TEST_CASE("permuting random points permutes their triangulation and nothing else") {
  const auto uv = random_uv(300, 6);
  std::vector<Index> order(300);
  for (Index i = 0; i < 300; ++i) order[i] = i;
  Random(8).shuffle(order);
  std::vector<UV> permuted;
  for (const Index i : order) permuted.push_back(uv[i]);
  auto triangles = delaunay(permuted, {});
  for (Triangle& t : triangles) {
    for (Index& id : t) id = order[id];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  CHECK(triangles == delaunay(uv, {}));
}

TEST_CASE("two points at one place: one of them is used") {
  auto uv = random_uv(50, 9);
  uv.push_back(uv[7]);
  std::vector<char> used(51, 0);
  for (const auto& t : delaunay(uv, {})) {
    for (const Index id : t) used[id] = 1;
  }
  CHECK(used[7] + used[50] == 1);
  CHECK(std::count(used.begin(), used.end(), 1) == 50);
}

TEST_CASE("a mesh that faces away from the normals, or from up, is turned round") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Triangle> triangles{{0, 2, 1}};
  CHECK(orient_mesh(points, triangles, {}, {0, 0, 1}));
  CHECK(triangles[0] == Triangle{0, 1, 2});
  CHECK_FALSE(orient_mesh(points, triangles, {}, {0, 0, 1}));
  CHECK(orient_mesh(points, triangles, std::vector<Point>(3, {0, 0, -1}), {0, 0, 1}));
}

}  // namespace
}  // namespace rimline
