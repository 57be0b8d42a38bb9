// SPDX-License-Identifier: GPL-3.0-or-later
// The Morton curve through the cells of a cube with 21 bits an axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rimline/points.h"

namespace rimline {

struct PointBox {
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
            std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
             std::numeric_limits<double>::lowest()};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const PointBox& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
  bool has(Point p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
  }
  // Halves first: the sum of two ends may overflow.
  Point centre() const { return 0.5 * low + 0.5 * high; }
  double extent() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

class MortonCurve {
 public:
  // Of the cube whose low corner is the box's and whose side is the longest of the box. All its points are in
  // one cell where that side is too small or too large for cells.
  explicit MortonCurve(const PointBox& box) : low_(box.low), scale_(cells / box.extent()) {
    if (!std::isfinite(scale_)) scale_ = 0;
  }

  bool has_cells() const { return scale_ > 0; }

  // Where a point of the box lies on the curve.
  std::uint64_t code(Point p) const {
    if (!has_cells()) return 0;
    return spread(p.x - low_.x) | spread(p.y - low_.y) << 1 | spread(p.z - low_.z) << 2;
  }

 private:
  static constexpr double cells = (1 << 21) - 1;

  // The 21 bits of the cell of an offset, with two zero bits behind each.
  std::uint64_t spread(double offset) const {
    auto bits = static_cast<std::uint64_t>(offset * scale_) & 0x1fffff;
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    bits = (bits | bits << 2) & 0x1249249249249249;
    return bits;
  }

  Point low_;
  double scale_;
};

}  // namespace rimline
