// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/mend_surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "grids.h"
#include "mesh/enclosure.h"
#include "mesh_rules.h"

namespace rimline {
namespace {

using shapes::Mesh;

// A torus of `around` by `through` points.
Mesh torus(Index around, Index through) {
  Mesh mesh;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < through; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / through;
      const double r = around / 6.0 + through / 6.3 * std::cos(b);
      mesh.points.push_back({r * std::cos(a), r * std::sin(a), through / 6.3 * std::sin(b)});
      const Index right = (i + 1) % around, up = (j + 1) % through;
      const Index p = i * through + j, q = right * through + j, s = right * through + up,
                  t = i * through + up;
      mesh.triangles.push_back({p, q, s});
      mesh.triangles.push_back({p, s, t});
    }
  }
  return mesh;
}

// A bumpy sheet, so that no area is zero.
Mesh sheet(Index side, Point at = {}) {
  Mesh mesh;
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x)
      mesh.points.push_back(at + Point{double(x), double(y), 0.1 * std::sin(x + 2.0 * y)});
  }
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      const Index a = y * side + x;
      mesh.triangles.push_back({a, a + 1, a + side + 1});
      mesh.triangles.push_back({a, a + side + 1, a + side});
    }
  }
  return mesh;
}

std::vector<MendedPart> mend(const Mesh& mesh, const std::vector<Loop>& loops = {},
                             HandlePolicy handles = HandlePolicy::Repair) {
  const Neighbours neighbours = find_neighbours(mesh.points, 12, {});
  const std::vector<double> spacing = local_spacing(mesh.points, neighbours);
  return mend_surface({mesh.points, neighbours, spacing, mesh.triangles, loops}, handles, {});
}

void check_part(const MendedPart& part, std::size_t points) {
  CHECK(test::broken_rule(part.triangles, static_cast<int>(points), part.orientable) == "");
  std::set<std::pair<int, int>> wanted;
  for (const Loop& loop : part.loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      wanted.insert(std::minmax({loop.points[i], loop.points[(i + 1) % loop.points.size()]}));
  }
  CHECK(test::rim_of(part.triangles) == wanted);
}

}  // namespace

TEST_CASE("a torus keeps its handle, and a triangle missing from it is put back") {
  Mesh mesh = torus(30, 12);
  const std::size_t whole = mesh.triangles.size();
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  const auto parts = mend(mesh);
  REQUIRE(parts.size() == 1);
  check_part(parts[0], mesh.points.size());
  CHECK(parts[0].triangles.size() == whole);
  CHECK(parts[0].genus == 1);
  CHECK(parts[0].orientable);
  CHECK(parts[0].loops.empty());
  CHECK(parts[0].repairs.empty());
}

// Two triangles are taken out of sheets that lie close, and their rims joined by a tube of six.
Mesh handle_between_sheets() {
  Mesh mesh = sheet(20);
  for (Point& p : mesh.points) {  // folded over, so that the halves lie face to face
    if (p.x > 9.5) p = {19 - p.x, p.y, p.z + 1.5};
  }
  const auto id = [](Index x, Index y) { return y * 20 + x; };
  const std::array<Index, 3> low{id(4, 8), id(5, 8), id(5, 9)}, high{id(15, 8), id(14, 8), id(15, 9)};
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const auto is = [&](const std::array<Index, 3>& x) { return std::ranges::is_permutation(t, x); };
    return is(low) || is(high);
  });
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3;
    mesh.triangles.push_back({low[c], low[d], high[d]});
    mesh.triangles.push_back({low[c], high[d], high[c]});
  }
  return mesh;
}

TEST_CASE(
    "a handle of three edges is cut where handles are mended, told with its place, and kept where not") {
  const Mesh mesh = handle_between_sheets();
  const auto kept = mend(mesh, {}, HandlePolicy::Keep);
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].genus == 1);
  check_part(kept[0], mesh.points.size());
  const auto parts = mend(mesh);
  REQUIRE(parts.size() == 1);
  check_part(parts[0], mesh.points.size());
  CHECK(parts[0].genus == 0);
  CHECK(parts[0].loops.size() == 1);
  REQUIRE(parts[0].repairs.size() == 1);
  const HandleRepair& repair = parts[0].repairs[0];
  CHECK(repair.points.size() <= 4);
  CHECK(repair.removed > 0);
  CHECK(repair.removed <= 24);
  CHECK(distance(repair.place, Point{4.5, 8.5, 0.75}) < 2);
  std::set<Index> used;
  for (const Triangle& t : parts[0].triangles) used.insert(t.begin(), t.end());
  CHECK(used.size() == mesh.points.size());
}

TEST_CASE("a Moebius strip stays one-sided") {
  const Mesh mesh = shapes::moebius(40, 5, 6.4, 5);
  const auto parts = mend(mesh);
  REQUIRE(parts.size() == 1);
  CHECK_FALSE(parts[0].orientable);
  CHECK(parts[0].genus == 1);
  CHECK(parts[0].loops.size() == 1);
  CHECK(parts[0].triangles.size() == mesh.triangles.size());
  check_part(parts[0], mesh.points.size());
}

TEST_CASE("sheets that touch in a point become components of which one has it, edges none or both") {
  Mesh mesh = sheet(8);
  const Mesh other = sheet(8, {7, 7, 0});
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin() + 1, other.points.end());
  for (Triangle t : other.triangles) {
    for (Index& v : t) v = v == 0 ? first - 1 : first + v - 1;  // the corner of both
    mesh.triangles.push_back(t);
  }
  const auto parts = mend(mesh);
  REQUIRE(parts.size() == 2);
  std::vector<Triangle> all;
  for (const MendedPart& part : parts) {
    check_part(part, mesh.points.size());
    all.insert(all.end(), part.triangles.begin(), part.triangles.end());
  }
  CHECK(test::broken_rule(all, static_cast<int>(mesh.points.size())) == "");
}

TEST_CASE("points over a triangle are put into it, those off the surface or beside it stay out") {
  Mesh mesh = sheet(12);
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.push_back({5.3, 5.4, 0.1});   // over
  mesh.points.push_back({5.3, 7.4, 3.0});   // off
  mesh.points.push_back({-0.7, 5.5, 0.0});  // beside
  const auto parts = mend(mesh);
  REQUIRE(parts.size() == 1);
  check_part(parts[0], mesh.points.size());
  std::set<Index> used;
  for (const Triangle& t : parts[0].triangles) used.insert(t.begin(), t.end());
  CHECK(used.contains(first));
  CHECK_FALSE(used.contains(first + 1));
  CHECK_FALSE(used.contains(first + 2));
}

TEST_CASE("closed surfaces and limbs have an outside, sheets have none") {
  Mesh ball = torus(30, 12);
  CHECK(faced_side(ball.points, ball.triangles, {}) == Side::Outward);
  for (Triangle& t : ball.triangles) std::swap(t[1], t[2]);
  CHECK(faced_side(ball.points, ball.triangles, {}) == Side::Inward);
  const Mesh flat = sheet(10);
  const auto parts = mend(flat);
  CHECK(faced_side(flat.points, parts[0].triangles, parts[0].loops) == Side::Unknown);
}

TEST_CASE("triangles between random neighbours of a cloud that is no surface become manifolds") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(0, 1);
  Mesh mesh;
  for (int i = 0; i < 500; ++i) mesh.points.push_back({side(random), side(random), side(random)});
  const Neighbours neighbours = find_neighbours(mesh.points, 8, {});
  for (Index i = 0; i < 500; ++i) {
    for (int k = 0; k < 6; ++k) {
      const auto near = neighbours.of(i);
      mesh.triangles.push_back({i, near[random() % 8], near[random() % 8]});
    }
  }
  std::size_t triangles = 0;
  for (const MendedPart& part : mend(mesh)) {
    check_part(part, mesh.points.size());
    triangles += part.triangles.size();
  }
  CHECK(triangles > 100);
}

}  // namespace rimline
