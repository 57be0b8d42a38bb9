// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/projected_charts.h"

#include <doctest/doctest.h>

#include "base/vec.h"
#include "grids.h"
#include "map/outline_crossings.h"
#include "rimline/map_by_charts.h"

namespace rimline {
namespace {

// Each triangle in one chart, none turned over, no outline that crosses itself, stretch within the bounds.
void check_charts(const std::vector<Chart>& charts, std::size_t triangles) {
  std::vector<int> count(triangles, 0);
  for (const Chart& chart : charts) {
    REQUIRE(chart.map);
    for (const Index t : chart.open.triangle) ++count[t];
    for (const Triangle& t : chart.open.mesh.triangles) CHECK(twice_area(chart.map->uv, t) > 0);
    CHECK(crossing_points(chart.open.loops, chart.map->uv).empty());
    const Stretch stretch = stretch_of_map(chart.open, chart.map->uv);
    CHECK(stretch.mean <= 1.75);
    CHECK(stretch.worst <= 4 + 1e-9);
  }
  for (const int c : count) CHECK(c == 1);
}

TEST_CASE("a plate full of holes is tangled, and mapped side by side") {
  const shapes::Mesh plate = shapes::pierced_plate(8);
  const OpenMesh open = open_surface(plate.points, plate.triangles);
  REQUIRE(open.genus == 64);
  CHECK(is_tangled(open));
  const auto charts = projected_charts(open, {});
  REQUIRE(charts);
  CHECK(charts->size() == 2 + 4 + 4 * 64);  // top and bottom, the outer sides, those of the holes
  check_charts(*charts, plate.triangles.size());
  CHECK(map_by_charts(plate.points, plate.triangles, {}, {}).charts == charts->size());
}

TEST_CASE("a torus, and a plate of few holes, are not tangled") {
  for (const shapes::Mesh& mesh : {shapes::torus(40, 20, 3, 1), shapes::pierced_plate(2)})
    CHECK(!is_tangled(open_surface(mesh.points, mesh.triangles)));
}

TEST_CASE("a ramp above itself is bisected until no projection overlaps") {
  const shapes::Mesh ramp = shapes::winding_ramp(3);
  const auto charts = projected_charts(open_surface(ramp.points, ramp.triangles), {});
  REQUIRE(charts);
  CHECK(charts->size() >= 3);
  CHECK(charts->size() <= 8);
  check_charts(*charts, ramp.triangles.size());
}

}  // namespace
}  // namespace rimline
