// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "rimline/points.h"

namespace rimline {

// The angles of a triangle at its three corners, radians; they sum to pi.
inline std::array<double, 3> corner_angles(Point a, Point b, Point c) {
  const double twice_area = norm(triangle_normal(a, b, c));
  const double at_a = std::atan2(twice_area, dot(b - a, c - a));
  const double at_b = std::atan2(twice_area, dot(c - b, a - b));
  return {at_a, at_b, std::max(0.0, std::numbers::pi - at_a - at_b)};
}

}  // namespace rimline
