// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/triangulation.h"

namespace rimline {

struct Foot {
  double squared = std::numeric_limits<double>::infinity();
  int corner = -1;  // the side opposite to this corner has the point; -1: the interior has it
};

inline Foot foot_on(Point p, const std::array<Point, 3>& v) {
  const Point normal = cross(v[1] - v[0], v[2] - v[0]);
  const double size = dot(normal, normal);
  bool inside = size > 0;
  for (int c = 0; c < 3; ++c)
    inside = inside && dot(cross(v[previous(c)] - v[next(c)], p - v[next(c)]), normal) >= 0;
  if (inside) return {dot(p - v[0], normal) * dot(p - v[0], normal) / size, -1};
  Foot foot;
  for (int c = 0; c < 3; ++c) {
    const Point a = v[next(c)], e = v[previous(c)] - a;
    const double t = std::clamp(dot(p - a, e) / std::max(dot(e, e), 1e-300), 0.0, 1.0);
    const double squared = squared_distance(p, a + t * e);
    if (squared < foot.squared) foot = {squared, c};
  }
  return foot;
}

}  // namespace rimline
