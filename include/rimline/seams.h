// SPDX-License-Identifier: GPL-3.0-or-later
// Where corners of triangles lie in a map of several charts: uv belongs to corners, not to points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// The places of points that have more than one: a place in each chart that they are in, and one on each side
// of a cut within a chart. All is empty where no point has more than one place.
struct Seams {
  std::vector<UV> uv;             // of these places, in units of the map
  std::vector<Index> point;       // whose each of them is
  std::vector<Triangle> corners;  // per triangle, the place at each corner: the id of the point, or the
                                  // number of points plus the position in `uv`

  bool empty() const { return point.empty(); }
};

// Where a corner (0 to 2) of a triangle lies. `uv` has one entry per point, which is NaN for a point of
// several places, and for one without any.
inline UV corner_uv(std::span<const UV> uv, const Seams& seams, std::span<const Triangle> triangles,
                    std::size_t triangle, int corner) {
  const Index at = (seams.empty() ? triangles : std::span<const Triangle>(seams.corners))[triangle][corner];
  return static_cast<std::size_t>(at) < uv.size() ? uv[at] : seams.uv[at - uv.size()];
}

}  // namespace rimline
