// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/handles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "grids.h"
#include "mesh/editable_mesh.h"
#include "mesh/orient.h"
#include "mesh_rules.h"

namespace rimline {
namespace {

constexpr Index side = 30;

Index id(Index x, Index y) { return y * side + x; }

using shapes::Mesh;

// A bumpy sheet, so that no area is zero.
Mesh sheet() {
  Mesh mesh;
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x)
      mesh.points.push_back({double(x), double(y), 0.1 * std::sin(x + 2.0 * y)});
  }
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      mesh.triangles.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1)});
      mesh.triangles.push_back({id(x, y), id(x + 1, y + 1), id(x, y + 1)});
    }
  }
  return mesh;
}

// Takes out two triangles and joins what opens by a tube of six.
void add_tube(Mesh& mesh, const std::array<Index, 3>& low, const std::array<Index, 3>& high) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::ranges::is_permutation(t, low) || std::ranges::is_permutation(t, high);
  });
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3;
    mesh.triangles.push_back({low[c], low[d], high[d]});
    mesh.triangles.push_back({low[c], high[d], high[c]});
  }
}

long long euler_number(const std::vector<Triangle>& triangles) {
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles) {
    vertices.insert(t.begin(), t.end());
    for (int c = 0; c < 3; ++c) edges.insert(std::minmax({t[c], t[(c + 1) % 3]}));
  }
  return static_cast<long long>(vertices.size() + triangles.size()) - static_cast<long long>(edges.size());
}

// What is left when everything was mended: a disc, as one finds by counting.
void check_disc(const Mesh& mesh, std::size_t least_repairs) {
  EditableMesh editable(mesh.points, mesh.triangles);
  const std::vector<HandleRepair> repairs = repair_handles(editable, {});
  std::vector<Triangle> triangles = editable.all();
  CHECK(orient_alike(triangles));
  CHECK(test::broken_rule(triangles, static_cast<int>(mesh.points.size())) == "");
  CHECK(euler_number(triangles) == 1);
  CHECK(walk_rims(editable).size() == 1);
  CHECK(repairs.size() >= least_repairs);
  for (const HandleRepair& repair : repairs) {
    CHECK(repair.points.size() <= 8);
    CHECK(repair.removed <= 24);
    CHECK(repair.length > 0);
  }
}

TEST_CASE("a tangle of handles is left as it is") {
  const Mesh plate = shapes::pierced_plate(8);  // each handle is a curve of four edges
  EditableMesh mesh(plate.points, plate.triangles);
  CHECK(repair_handles(mesh, {}).empty());
  const Mesh few = shapes::pierced_plate(3);
  EditableMesh other(few.points, few.triangles);
  CHECK(!repair_handles(other, {}).empty());
}

}  // namespace

TEST_CASE("many small handles of one surface are all mended") {
  Mesh mesh = sheet();
  for (Index k = 0; k < 4; ++k) {
    for (Index j = 0; j < 3; ++j) {
      const Index x = 3 + 6 * k, y = 4 + 9 * j;
      add_tube(mesh, {id(x, y), id(x + 1, y), id(x + 1, y + 1)},
               {id(x + 2, y + 3), id(x + 2, y + 4), id(x + 3, y + 4)});
    }
  }
  CHECK(euler_number(mesh.triangles) == 1 - 24);
  check_disc(mesh, 12);
}

TEST_CASE("a narrow band that is glued on at the rim with a twist is cut") {
  Mesh mesh = sheet();
  const Index a = id(10, 0), b = id(11, 0), c = id(20, 0), d = id(21, 0);
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back(
      {b, c, d});  // a joins c and b joins d: twisted, both rims running from left to right
  std::vector<Triangle> triangles = mesh.triangles;
  CHECK_FALSE(orient_alike(triangles));
  check_disc(mesh, 1);
}

TEST_CASE("narrow bands that interlock at the rim are a handle, and cut so that one rim is left") {
  Mesh mesh = sheet();
  for (const Index x : {8, 12}) {  // from 8 to 16, from 12 to 20
    const Index a = id(x, 0), b = id(x + 1, 0), c = id(x + 8, 0), d = id(x + 9, 0);
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({b, c, d});
  }
  std::vector<Triangle> triangles = mesh.triangles;
  CHECK(orient_alike(triangles));
  CHECK(euler_number(triangles) == -1);
  check_disc(mesh, 1);
}

TEST_CASE("a small handle beside the rim is mended, and the rim is left") {
  Mesh mesh = sheet();
  add_tube(mesh, {id(5, 0), id(6, 0), id(6, 1)}, {id(8, 2), id(8, 3), id(9, 3)});
  check_disc(mesh, 1);
}

TEST_CASE("a Moebius strip of four points across is true, and stays") {
  const Mesh mesh = shapes::moebius(40, 3, 6.4, 3);
  EditableMesh editable(mesh.points, mesh.triangles);
  CHECK(repair_handles(editable, {}).empty());
  CHECK(editable.all().size() == mesh.triangles.size());
}

}  // namespace rimline
