// SPDX-License-Identifier: GPL-3.0-or-later
// Small point sets that need no file and no sampler.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::shapes {

// A disc of radius 1: `rings` rings, ring r with 6 r points, and the centre. The rim is the last ring.
struct Disc {
  std::vector<Point> points;
  std::vector<Index> rim;  // counter-clockwise from above
};

inline Disc disc(int rings, double bump = 0, std::uint64_t seed = 1, double jitter = 0.2) {
  Disc d;
  Random random(seed);
  d.points.push_back({0, 0, bump});
  for (int r = 1; r <= rings; ++r) {
    for (int i = 0; i < 6 * r; ++i) {
      // Inner points are shaken a little, so that no four of them lie on a circle.
      const double shake = r < rings ? jitter / rings : 0;
      const double radius = 1.0 * r / rings + shake * (random.uniform() - 0.5);
      const double angle =
          2 * std::numbers::pi * (i + 0.5 * (r % 2)) / (6 * r) + shake * (random.uniform() - 0.5);
      if (r == rings) d.rim.push_back(static_cast<Index>(d.points.size()));
      d.points.push_back({radius * std::cos(angle), radius * std::sin(angle), bump * (1 - radius * radius)});
    }
  }
  return d;
}

// A rotation by three angles, applied to all points.
inline std::vector<Point> turned(const std::vector<Point>& points, double a, double b, double c) {
  std::vector<Point> result;
  for (Point p : points) {
    p = {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a), p.z};
    p = {p.x * std::cos(b) - p.z * std::sin(b), p.y, p.x * std::sin(b) + p.z * std::cos(b)};
    p = {p.x, p.y * std::cos(c) - p.z * std::sin(c), p.y * std::sin(c) + p.z * std::cos(c)};
    result.push_back(p);
  }
  return result;
}

}  // namespace rimline::shapes
