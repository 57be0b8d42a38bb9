// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_map.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace rimline::cli {

TEST_CASE("the 40 charts of most triangles are drawn, and the others counted") {
  // Chart c is a strip of c + 1 triangles over the points of its own.
  std::vector<Point> points;
  std::vector<UV> uv;
  std::vector<Triangle> triangles;
  std::vector<Index> chart;
  for (Index c = 0; c < 45; ++c) {
    const auto first = static_cast<Index>(points.size());
    for (Index i = 0; i < c + 3; ++i) {
      points.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 1.0, 2.0 * c});
      uv.push_back({0.5 * i, (i % 2 == 0 ? 0.0 : 1.0) + 2 * c});
    }
    for (Index i = 0; i < c + 1; ++i) {
      triangles.push_back(i % 2 == 0 ? Triangle{first + i, first + i + 2, first + i + 1}
                                     : Triangle{first + i, first + i + 1, first + i + 2});
      chart.push_back(c);
    }
  }
  const BoundaryResult boundary;
  const Scene scene{.points = points, .boundary = boundary, .uv = uv, .triangles = triangles, .chart = chart};
  const DrawnMap map = drawn_map(scene);
  CHECK(map.charts == 40);
  CHECK(map.left_out == 5);
  CHECK(tell_charts(map) == "the largest 40 of 45 charts");
  CHECK(map.corners.size() == triangles.size() - 15);  // 1 + 2 + 3 + 4 + 5
  CHECK(std::isnan(map.uv[0].u));
  CHECK(std::isfinite(map.uv.back().u));
}

TEST_CASE("outlines are boundary, and seams where the surface goes on") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> two{{0, 1, 2}, {0, 2, 3}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<UV> uv{{nan, nan}, {1, 0}, {nan, nan}, {2, 1}};
  const Seams seams{{{0, 0}, {2, 0}, {1, 1}, {3, 1}}, {0, 0, 2, 2}, {{4, 1, 6}, {5, 7, 3}}};
  const std::vector<Index> chart{0, 1};
  const BoundaryResult boundary;
  const Scene scene{
      .points = points, .boundary = boundary, .uv = uv, .triangles = two, .seams = seams, .chart = chart};
  const Outline outline = outline_of(drawn_map(scene));
  CHECK(outline.boundary.size() == 4);
  CHECK(outline.seams.size() == 2);  // the diagonal, once in each chart
}

}  // namespace rimline::cli
