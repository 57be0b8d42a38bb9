// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a mesh to a convex domain, free of flips.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/report.h"

namespace rimline {

// Triangles whose uv is not counter-clockwise, ascending.
std::vector<Index> flipped_triangles(const std::vector<Triangle>& triangles, const std::vector<UV>& uv,
                                     const Run& run);

struct Embedding {
  MapSummary map;
  std::size_t flips = 0;   // 0 but for maps that double precision can not hold
  std::size_t evened = 0;  // points whose weights were drawn towards 1 to get there
};

// Maps a disc with holes: the first loop stays where `uv` has it (a convex polygon, counter-clockwise), the
// holes are closed by a wheel each. `uv` holds one entry per point and one per hole, a first guess for what
// is not on the first loop. Starts from the harmonic map; where rounding flips triangles, draws the weights
// about them towards Tutte's equal ones, `repairs` times at most, until none is flipped.
Embedding embed(Points points, const Triangulation& mesh, const std::vector<Loop>& loops, double residual,
                int repairs, std::vector<UV>& uv, const Run& run);

}  // namespace rimline
