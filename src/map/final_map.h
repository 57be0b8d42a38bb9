// SPDX-License-Identifier: GPL-3.0-or-later
// Maps a finished mesh to the requested domain.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/refine_surface.h"

namespace rimline {

struct FinalMap {
  std::vector<UV> uv;  // one per point
  Domain kind =
      Domain::Disc;    // the result: the disc, at the area of the surface, where a free map could not be made
  MapSummary summary;  // the last system
  std::size_t flips = 0;   // triangles not counter-clockwise
  std::size_t evened = 0;  // points whose weights were equalized to avoid flips
};

// `loops`: the outer one first. `uv`: one per point and one per hole, the outer loop on the circle, a first
// guess for the others. options.domain must not be None.
FinalMap final_map(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                   const RefineOptions& options, std::vector<UV> uv, const Run& run);

}  // namespace rimline
