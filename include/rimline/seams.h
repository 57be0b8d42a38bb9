// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of triangle corners in a map of several charts: uv belongs to corners, not to points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// Positions of points that have more than one: one in each chart that the point is in, and one on each side
// of a cut within a chart. Empty where no point has more than one.
struct Seams {
  std::vector<UV> uv;             // of each position, in units of the map
  std::vector<Index> point;       // the point of each position
  std::vector<Triangle> corners;  // per triangle and corner: the id of the point, or the number of points
                                  // plus the index in `uv`

  bool empty() const { return point.empty(); }
};

// The position of a corner (0 to 2) of a triangle. `uv` has one entry per point, NaN for a point of several
// positions or of none.
inline UV corner_uv(std::span<const UV> uv, const Seams& seams, std::span<const Triangle> triangles,
                    std::size_t triangle, int corner) {
  const Index at = (seams.empty() ? triangles : std::span<const Triangle>(seams.corners))[triangle][corner];
  return static_cast<std::size_t>(at) < uv.size() ? uv[at] : seams.uv[at - uv.size()];
}

}  // namespace rimline
