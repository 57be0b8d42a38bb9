// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "rimline/points.h"

namespace rimline {

// The cotangent of the angle at p between a and b; huge where they coincide.
inline double cotangent(Point p, Point a, Point b) {
  const Point e = a - p, f = b - p;
  return dot(e, f) / std::max(norm(cross(e, f)), 1e-300);
}

}  // namespace rimline
