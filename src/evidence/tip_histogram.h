// SPDX-License-Identifier: GPL-3.0-or-later
// How wide the widest angles of a surface's triangles are.
#pragma once

#include <array>
#include <cstdint>

#include "rimline/run.h"
#include "surface/triangle_set.h"

namespace rimline {

// The widest angle of a triangle, its tip, in radians: pi / 3 to pi.
double tip_of(const TriangleSet& set, Index triangle);

// A wide triangle at a rim closes a notch where the surface has few such triangles, and is nothing unusual where
// points lie in rows. Counts the tips of the triangles of a set that touch no rim.
class TipHistogram {
 public:
  TipHistogram() = default;
  TipHistogram(const TriangleSet& set, const Run& run);

  // Minus the logarithm of the share of these triangles whose tip is about as wide or wider; of one more than
  // there are, which has any.
  double log_tail(double tip) const;

 private:
  static constexpr int intervals = 512;  // of equal width, from pi / 3 to pi [layout]

  static int interval_of(double tip);

  std::array<std::uint32_t, intervals> wider_{};  // in this interval or above
};

}  // namespace rimline
