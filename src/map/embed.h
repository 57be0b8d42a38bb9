// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a mesh to a convex domain, free of flips.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/report.h"

namespace rimline {

// Whether the triangle is counter-clockwise in uv, and its height above `least` times its longest side there.
bool has_height(const std::vector<UV>& uv, const Triangle& t, double least);

// Triangles whose uv is not counter-clockwise, ascending; with those without height where `least` is above 0.
std::vector<Index> flipped_triangles(const std::vector<Triangle>& triangles, const std::vector<UV>& uv,
                                     const Run& run, double least = 0);

struct Embedding {
  MapSummary map;
  std::size_t flips = 0;   // 0 except for maps beyond double precision
  std::size_t evened = 0;  // points whose weights were equalized
};

// Maps a disc with holes. The first loop keeps its positions in `uv` (a convex polygon, counter-clockwise);
// each hole is closed by a wheel. `uv` has one entry per point and one per hole: a first guess except on the
// first loop. Starts from the harmonic map; where rounding flips triangles, or leaves them below the height
// `least`, the weights around them are moved towards equal ones (Tutte), at most `repairs` times.
Embedding embed(Points points, const Triangulation& mesh, const std::vector<Loop>& loops, double residual,
                int repairs, std::vector<UV>& uv, const Run& run, double least = 0);

}  // namespace rimline
