// SPDX-License-Identifier: GPL-3.0-or-later
// An order of triangles by their coordinates, independent of the numbering of the points.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// Settles ties: by the coordinates of the corners, the least corner first; where these are equal, by id.
class TriangleOrder {
 public:
  explicit TriangleOrder(Points points) : points_(points) {}

  bool operator()(const Triangle& a, const Triangle& b) const {
    const auto at_a = corners(a), at_b = corners(b);
    return at_a != at_b ? at_a < at_b : a < b;
  }

 private:
  std::array<std::tuple<double, double, double>, 3> corners(const Triangle& t) const {
    std::array<std::tuple<double, double, double>, 3> found;
    for (int i = 0; i < 3; ++i) found[i] = {points_[t[i]].x, points_[t[i]].y, points_[t[i]].z};
    std::sort(found.begin(), found.end());
    return found;
  }

  Points points_;
};

}  // namespace rimline
