// SPDX-License-Identifier: GPL-3.0-or-later
// The free map of one chart.
#pragma once

#include <optional>
#include <vector>

#include "map/open_mesh.h"
#include "rimline/report.h"

namespace rimline {

struct ChartMap {
  std::vector<UV> uv;  // one per vertex, at the area of the surface, its longest way level
  Domain kind = Domain::Free;
  MapSummary summary;
};

// A conformal map of a disc with holes: no triangle turned over, no outline that crosses itself or another.
// The loops of `open` may be taken in any order. Ways are tried until one gives such a map: for large charts
// the outline first; least squares; the inside anew within the outline that least squares gave; Newton's
// descent from there or from the disc's map. Nothing where none does. `patient`: whether to try what takes
// minutes on 100,000 vertices.
std::optional<ChartMap> free_chart(const OpenMesh& open, const std::vector<double>& turning, double residual,
                                   bool patient, const Run& run);

// The map to the disc, at the area of the surface. Nothing where it turns triangles over.
std::optional<ChartMap> disc_chart(const OpenMesh& open, double residual, const Run& run);

}  // namespace rimline
