// SPDX-License-Identifier: GPL-3.0-or-later
// From a surface of any topology to the plane, by charts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/options.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

struct ChartOptions {
  int charts = 0;           // ParameterizeOptions::charts
  double mean_stretch = 2;  // most that a chart may have, Sander's L2 area for area, where the choice is free
  double worst_stretch = 100;  // likewise, Linf
  double residual = 1e-10;     // of each linear system, relative to its right-hand side
};

// Where the corners of triangles lie.
struct ChartedMap {
  Domain kind =
      Domain::None;  // Free; Disc where charts = 1 and there is no free map; None where there is none
  std::size_t charts = 0;
  double seams = 0;           // length of the edges that were cut, in the unit of the points
  std::vector<UV> uv;         // of each place; every chart has the area of its surface, and starts at (0, 0)
  std::vector<Index> vertex;  // of each place
  std::vector<Triangle> corners;     // per triangle, the places of its corners
  std::vector<Index> chart;          // per triangle
  std::vector<std::uint8_t> turned;  // per triangle, 1 where it runs against the others of its chart: on a
                                     // one-sided surface, whose triangles have no common side. Its corners
                                     // are then in the order (0, 2, 1)
  MapSummary summary;                // all systems as one
};

// Maps one component of any topology. Each edge must have one triangle or two, each vertex one fan. Handles
// are cut along short closed curves, one-sided surfaces across; a disc with holes is one chart. Charts whose
// stretch exceeds the bounds are cut further: tubes lengthwise, others in two where the cut is short. No
// triangle is flipped and no outline crosses itself; a chart for which that can not be done is cut as well.
// With charts = 1 there is one chart or none. Throws Cancelled.
ChartedMap map_by_charts(Points points, const std::vector<Triangle>& triangles, const ChartOptions& options,
                         const Run& run);

}  // namespace rimline
