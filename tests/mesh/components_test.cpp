// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/components.h"

#include <doctest/doctest.h>

namespace rimline {
namespace {

// A row of `count` squares of two triangles each, which do not agree in orientation.
std::vector<Triangle> row_of_squares(Index count) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i;
    triangles.push_back({a, a + 2, a + 3});
    triangles.push_back(i % 3 == 0 ? Triangle{a, a + 1, a + 3} : Triangle{a, a + 3, a + 1});
  }
  return triangles;
}

TEST_CASE("links lead to the triangle across each edge and back, whichever way triangles run") {
  const Triangulation mesh = link_triangles(row_of_squares(20));
  int open = 0;
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = mesh.adjacent[t][c];
      open += other == none;
      if (other == none) continue;
      CHECK(mesh.adjacent[other][mesh.corner_across(other, t)] == t);
      const Triangle& x = mesh.triangles[t];
      CHECK(mesh.corner_opposite(other, x[next(c)], x[previous(c)]) == mesh.corner_across(other, t));
    }
  }
  CHECK(open == 2 * 20 + 2);
}

TEST_CASE("a mesh parted by cleared links has a component on each side, and all agree in orientation") {
  Triangulation mesh = link_triangles(row_of_squares(10));
  const Components whole = find_components(mesh);
  CHECK(whole.count() == 1);
  const auto agreeing = [&](Index t) {
    const Triangle& x = mesh.triangles[t];
    return whole.turned[t] ? Triangle{x[0], x[2], x[1]} : x;
  };
  int turned = 0;
  for (Index t = 0; t < mesh.size(); ++t) {
    turned += whole.turned[t];
    const Triangle x = agreeing(t);
    for (int c = 0; c < 3; ++c) {
      const Index a = x[next(c)], b = x[previous(c)];
      const Index other = mesh.adjacent[t][mesh.corner_opposite(t, a, b)];
      if (other != none) CHECK(runs(agreeing(other), b, a));
    }
  }
  CHECK(turned > 0);
  for (Index t = 0; t < mesh.size(); ++t) {
    for (Index& other : mesh.adjacent[t]) {
      if ((t < 8) != (other < 8)) other = none;
    }
  }
  const Components parts = find_components(mesh);
  CHECK(parts.count() == 2);
  for (Index t = 0; t < mesh.size(); ++t) CHECK(parts.of_triangle[t] == (t < 8 ? 0 : 1));
}

}  // namespace
}  // namespace rimline
