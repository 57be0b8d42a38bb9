// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a map that a picture shows: whole charts, the largest ones.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "picture.h"

namespace rimline::cli {

struct DrawnMap {
  std::vector<UV> uv;                    // of each place; NaN for those that are not drawn
  std::vector<Triangle> triangles;       // of the mesh
  std::vector<Triangle> corners;         // of each of these, its places
  std::size_t charts = 0, left_out = 0;  // number of charts that are drawn, and that are not
};

// The 40 charts of most triangles. Of equal ones the first.
DrawnMap drawn_map(const Scene& scene);

// "3 charts", "the largest 40 of 72 charts"; "" for one.
std::string tell_charts(const DrawnMap& map);

// The edges of the drawn charts' outlines, as places, and whether each is a seam: not at the mesh's boundary.
struct Outline {
  std::vector<std::pair<Index, Index>> boundary, seams;
};
Outline outline_of(const DrawnMap& map);

}  // namespace rimline::cli
