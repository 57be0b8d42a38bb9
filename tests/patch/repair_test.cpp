// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "mesh/constrained_delaunay.h"
#include "rimline/measure.h"
#include "shapes.h"

namespace rimline {
namespace {

struct Sheet {
  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<Loop> loops;
  std::vector<Triangle> triangles;
};

Sheet make_sheet() {
  Sheet sheet;
  const shapes::Disc disc = shapes::disc(12);
  sheet.points = disc.points;
  sheet.neighbours = find_neighbours(sheet.points, 12, {});
  sheet.loops = {{disc.rim, LoopKind::Outer}};
  std::vector<UV> uv;
  for (const Point& p : sheet.points) uv.push_back({p.x, p.y});
  sheet.triangles = constrained_delaunay(uv, sheet.loops);
  return sheet;
}

std::optional<Triangulation> mesh_of(const Sheet& sheet) {
  return mesh_of_survey(sheet.points, sheet.neighbours, sheet.loops, sheet.triangles);
}

void drop_triangles_of(Sheet& sheet, Index vertex) {
  std::erase_if(sheet.triangles, [&](const Triangle& t) { return std::ranges::count(t, vertex) > 0; });
}

// All points on a disc that ends at the loop, and neighbours that know each other.
void check_disc(const Sheet& sheet, const std::optional<Triangulation>& mesh) {
  REQUIRE(mesh);
  const MeshSummary m =
      measure_mesh(sheet.points, mesh->triangles, std::vector<double>(sheet.points.size(), 1), {});
  CHECK(m.points_used == sheet.points.size());
  CHECK(m.euler == 1);
  CHECK(m.boundary_edges == sheet.loops[0].points.size());
  CHECK(m.nonmanifold_edges + m.nonmanifold_vertices == 0);
  const Triangulation again = triangulation_of(mesh->triangles, static_cast<Index>(sheet.points.size()));
  CHECK(again.adjacent == mesh->adjacent);
  double area = 0;
  for (std::size_t i = 0; i < sheet.loops[0].points.size(); ++i) {
    const auto& ids = sheet.loops[0].points;
    area += cross(sheet.points[ids[i]], sheet.points[ids[(i + 1) % ids.size()]]).z / 2;
  }
  CHECK(m.area == doctest::Approx(area).epsilon(1e-3));  // before flips a point may lie beside its triangle
}

}  // namespace

TEST_CASE("triangles that are a mesh already stay as they are") {
  const Sheet sheet = make_sheet();
  const auto mesh = mesh_of(sheet);
  check_disc(sheet, mesh);
  CHECK(mesh->triangles == sheet.triangles);
}

TEST_CASE("gaps are closed, and points without a triangle are put in") {
  Sheet sheet = make_sheet();
  drop_triangles_of(sheet, 0);
  drop_triangles_of(sheet, 100);
  drop_triangles_of(sheet, 101);
  check_disc(sheet, mesh_of(sheet));
}

TEST_CASE("of two fans that meet in a point alone one stays, and what it leaves is closed") {
  Sheet sheet = make_sheet();
  std::vector<std::size_t> star;  // two triangles at point 50 that share no edge go
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    if (std::ranges::count(sheet.triangles[t], 50) > 0) star.push_back(t);
  }
  const auto shared = [&](std::size_t a, std::size_t b) {
    return std::ranges::count_if(sheet.triangles[a],
                                 [&](Index v) { return std::ranges::count(sheet.triangles[b], v) > 0; });
  };
  const auto other = std::ranges::find_if(star, [&](std::size_t t) { return shared(star[0], t) == 1; });
  REQUIRE(other != star.end());
  sheet.triangles.erase(sheet.triangles.begin() + static_cast<std::ptrdiff_t>(*other));
  sheet.triangles.erase(sheet.triangles.begin() + static_cast<std::ptrdiff_t>(star[0]));
  check_disc(sheet, mesh_of(sheet));
}

TEST_CASE("triangles that do not end at the loop, lack too much or have a handle are no start") {
  Sheet sheet = make_sheet();
  SUBCASE("a triangle at the loop is missing") { drop_triangles_of(sheet, sheet.loops[0].points[3]); }
  SUBCASE("many points have no triangle") {
    for (Index v = 40; v < 80; ++v) drop_triangles_of(sheet, v);
  }
  SUBCASE("a tube joins two holes") {  // the rims of two stars are joined crosswise
    const auto ring_of = [&](Index vertex) {
      std::map<Index, Index> next;
      for (const auto& [a, b, c] : sheet.triangles) {
        if (a == vertex) next[b] = c;
        if (b == vertex) next[c] = a;
        if (c == vertex) next[a] = b;
      }
      std::vector<Index> ring{next.begin()->first};
      while (next[ring.back()] != ring.front()) ring.push_back(next[ring.back()]);
      return ring;
    };
    auto a = ring_of(20), b = ring_of(150);
    std::reverse(b.begin(), b.end());
    drop_triangles_of(sheet, 20);
    drop_triangles_of(sheet, 150);
    const std::size_t n = std::min(a.size(), b.size());
    a.resize(n);
    b.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      sheet.triangles.push_back({a[i], a[j], b[i]});
      sheet.triangles.push_back({a[j], b[j], b[i]});
    }
  }
  CHECK_FALSE(mesh_of(sheet));
}

}  // namespace rimline
