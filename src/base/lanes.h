// SPDX-License-Identifier: GPL-3.0-or-later
// Eight points at a time, one in each lane. Loops over lanes become vector instructions of any width, with
// the same bytes as one point at a time.
#pragma once

#include "rimline/points.h"

namespace rimline {

inline constexpr int lanes = 8;

// A number of each point; aligned, so that none lies across two cache lines.
struct alignas(64) Lanes {
  double number[lanes];

  double& operator[](int l) { return number[l]; }
  double operator[](int l) const { return number[l]; }
};

// Selects one of two points, coordinate by coordinate, so that a loop over lanes has no branch.
inline Point choose(bool first, Point a, Point b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

}  // namespace rimline
