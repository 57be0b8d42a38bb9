// SPDX-License-Identifier: GPL-3.0-or-later
// Frequency of wide corners of large triangles on the surface behind rims.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rimline/neighbours.h"
#include "surface/local_size.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// A wide, large triangle at a rim is a false ear where the surface behind has none like it; where points are
// uneven everywhere it is usual.
class CornerHistogram {
 public:
  CornerHistogram() = default;
  // Counts the corners of the selected triangles near jagged rims that touch no rim.
  CornerHistogram(const TriangleSet& set, const LocalSizes& sizes, const Neighbours& neighbours,
                  const std::vector<std::vector<Index>>& rims, const Selection& selected);

  // Adds the corners of another part of the surface; the result is the histogram of both.
  CornerHistogram& operator+=(const CornerHistogram& other);

  // Minus the logarithm of the share of these corners that are about as wide or wider, in radians, in
  // triangles of that log_ratio or more. 0 where none were counted.
  double log_tail(double angle, double log_ratio) const;

 private:
  static constexpr int angles = 64, ratios = 64;  // intervals: 3 degrees; a tenth of an e-fold [layout]

  std::array<std::array<std::uint32_t, ratios>, angles> count_{};  // in this interval of both or above
};

}  // namespace rimline
