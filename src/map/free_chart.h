// SPDX-License-Identifier: GPL-3.0-or-later
// The free map of one chart.
#pragma once

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

// A conformal map of a disc with holes, without flips or crossing outlines. The loops of `open` may be in any
// order. Several methods are tried: for large charts first the outline, then the inside; least squares; the
// inside again within the outline of least squares; Newton's descent from there or from the disc's map. None
// where all fail. `patient`: whether to try methods that take minutes for 100,000 vertices.
std::optional<ChartMap> free_chart(const OpenMesh& open, const std::vector<double>& turning, double residual,
                                   bool patient, const Run& run);

// The map to the disc, at the area of the surface. None where it flips triangles.
std::optional<ChartMap> disc_chart(const OpenMesh& open, double residual, const Run& run);

}  // namespace rimline
