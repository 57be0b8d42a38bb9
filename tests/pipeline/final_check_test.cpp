// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/final_check.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rimline/stage_clock.h"

namespace rimline::pipeline {
namespace {

// Two sheets of 8 by 8 points, 100 apart, each meshed and mapped as a component with its loop.
struct Sheets {
  std::vector<Point> input;
  PreparedPoints prepared;
  MappedMesh mesh;

  Sheets() {
    for (const double x : {0.0, 100.0}) {
      for (int i = 0; i < 64; ++i) input.push_back({x + i % 8, double(i / 8), 0.1 * std::sin(i)});
    }
    StageClock clock;
    prepared = prepare(input, {}, {}, {}, clock);
    mesh.vertices = prepared.points();
    for (const Point& p : input) mesh.uv.push_back({p.x, p.y});
    mesh.components.resize(2);
    mesh.loops.resize(2);
    std::vector<Index> place(input.size());  // in the arrangement
    for (std::size_t v = 0; v < input.size(); ++v) place[prepared.ids()[v]] = static_cast<Index>(v);
    mesh.uv.resize(input.size());
    mesh.patch.resize(input.size());
    for (Index s = 0; s < 2; ++s) add_sheet(s, place);
  }

  void add_sheet(Index s, const std::vector<Index>& place) {
    const auto at = [&](Index x, Index y) { return place[64 * s + 8 * y + x]; };
    for (Index y = 0; y < 8; ++y) {
      for (Index x = 0; x < 8; ++x) {
        mesh.patch[at(x, y)] = s;
        mesh.uv[at(x, y)] = {100.0 * s + x, double(y)};
        if (x == 7 || y == 7) continue;
        mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
        mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    }
    mesh.triangle_patch.resize(mesh.triangles.size(), s);
    mesh.filled.resize(mesh.triangles.size(), 0);
    Loop& loop = mesh.loops[s];
    for (Index i = 0; i < 7; ++i) loop.points.push_back(at(i, 0));
    for (Index i = 0; i < 7; ++i) loop.points.push_back(at(7, i));
    for (Index i = 7; i > 0; --i) loop.points.push_back(at(i, 7));
    for (Index i = 7; i > 0; --i) loop.points.push_back(at(0, i));
    mesh.components[s].map = Domain::Disc;
    mesh.components[s].triangles = 98;
  }
};

// The second sheet is left out and told with its ids; the first is as it was.
void check_second_left_out(const Sheets& sheets, const MappedMesh& mesh) {
  CHECK(mesh.triangles.size() == 98);
  CHECK(mesh.loops.size() == 1);
  CHECK_FALSE(mesh.warnings.empty());
  CHECK(mesh.components[1].triangles == 0);
  CHECK(mesh.components[1].failure != "");
  REQUIRE(mesh.left_out.size() == 1);
  const LeftOut& part = mesh.left_out[0];
  CHECK(part.component == 1);
  CHECK(part.cause == mesh.components[1].failure);
  CHECK(part.remedy != "");
  REQUIRE(part.ids.size() == 64);
  for (Index i = 0; i < 64; ++i) CHECK(part.ids[i] == 64 + i);
  CHECK(part.low.x == 100);
  CHECK(part.high.x == 107);
  CHECK(sheets.input.size() == 128);
}

}  // namespace

TEST_CASE("a valid mesh passes the final check as it is") {
  Sheets sheets;
  const MappedMesh mesh = checked(sheets.mesh, sheets.prepared, {});
  CHECK(mesh.triangles == sheets.mesh.triangles);
  CHECK(mesh.left_out.empty());
  CHECK(mesh.warnings.empty());
}

TEST_CASE("a component that is no manifold is left out and listed with its ids and its box") {
  Sheets sheets;
  SUBCASE("a triangle twice") { sheets.mesh.triangles[120] = sheets.mesh.triangles[121]; }
  SUBCASE("a repeated corner") { sheets.mesh.triangles[120][0] = sheets.mesh.triangles[120][1]; }
  SUBCASE("a loop that is not its boundary") {
    std::swap(sheets.mesh.loops[1].points[2], sheets.mesh.loops[1].points[5]);
  }
  SUBCASE("a corner of the other component") { sheets.mesh.triangles[120][0] = sheets.mesh.triangles[0][0]; }
  const MappedMesh mesh = checked(sheets.mesh, sheets.prepared, {});
  check_second_left_out(sheets, mesh);
}

TEST_CASE("a map that turns a triangle over is left out, and the mesh is kept") {
  Sheets sheets;
  for (UV& p : sheets.mesh.uv) {
    if (p.u > 50) p.v = -p.v;
  }
  const MappedMesh mesh = checked(sheets.mesh, sheets.prepared, {});
  CHECK(mesh.triangles.size() == sheets.mesh.triangles.size());
  CHECK(mesh.left_out.empty());
  CHECK(mesh.components[0].map == Domain::Disc);
  CHECK(mesh.components[1].map == Domain::None);
  for (std::size_t v = 0; v < mesh.uv.size(); ++v) CHECK(std::isnan(mesh.uv[v].u) == (mesh.patch[v] == 1));
}

}  // namespace rimline::pipeline
