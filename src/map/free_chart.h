// SPDX-License-Identifier: GPL-3.0-or-later
// The free map of one chart.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "map/open_mesh.h"
#include "rimline/report.h"

namespace rimline {

struct ChartMap {
  std::vector<UV>
      uv;  // one per vertex, at the area of the surface, rotated so that its longest extent is level
  Domain kind = Domain::Free;
  MapSummary summary;
};

// What may be done for the free map of a chart.
struct ChartEffort {
  std::int64_t work = 1'000'000'000;  // most steps of a descent times triangles: no descent where that is few
  double isometry = 0;                // weight of what keeps lengths in a descent (conformal_energy.h)
};

// Nothing where no map was found; then, too, `work` tells steps of descents times triangles.
struct FreeChart {
  std::optional<ChartMap> map;
  std::int64_t work = 0;
};

// A conformal map of a disc with holes: no triangle turned over, no outline that crosses itself or another.
// The loops of `open` may be taken in any order. Ways are tried until one gives such a map: for large charts
// the outline first; least squares; the inside anew within the outline that least squares gave; Newton's
// descent from there or from the disc's map.
FreeChart free_chart(const OpenMesh& open, const std::vector<double>& turning, double residual,
                     const ChartEffort& effort, const Run& run);

// The outline first, by how it turns at each of its points; none where that is no map of that kind.
std::optional<ChartMap> outline_first_chart(const OpenMesh& open, const std::vector<double>& turning,
                                            double residual, const Run& run);

// Descends from a map of that kind.
FreeChart evened_chart(const OpenMesh& open, const ChartMap& from, const ChartEffort& effort, const Run& run);

// A given map at the area of the surface, where it is one of that kind.
std::optional<ChartMap> given_chart(const OpenMesh& open, std::vector<UV> uv);

// The map to the disc, at the area of the surface. None where it flips triangles.
std::optional<ChartMap> disc_chart(const OpenMesh& open, double residual, const Run& run);

}  // namespace rimline
