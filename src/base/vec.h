// SPDX-License-Identifier: GPL-3.0-or-later
// Basic geometry: cyclic indices, triangles in space.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// The index after `i` in a cycle of `count`.
template <class Place, class Count>
constexpr Place next_in(Place i, Count count) {
  return i + 1 < static_cast<Place>(count) ? i + 1 : 0;
}

// The normal of a triangle, of length twice its area; the triangle is counter-clockwise seen from the tip.
constexpr Point triangle_normal(Point a, Point b, Point c) { return cross(b - a, c - a); }
constexpr Point triangle_normal(Points points, const Triangle& t) {
  return triangle_normal(points[t[0]], points[t[1]], points[t[2]]);
}

// Twice the area of a triangle in the plane, negative where it is clockwise.
constexpr double twice_area(UV a, UV b, UV c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}
constexpr double twice_area(const std::vector<UV>& uv, const Triangle& t) {
  return twice_area(uv[t[0]], uv[t[1]], uv[t[2]]);
}

// The unit vector of a direction; zero for a vector of length zero.
inline Point unit(Point p) { return (1 / std::max(norm(p), 1e-300)) * p; }

inline double triangle_area(Points points, const Triangle& t) {
  return 0.5 * norm(triangle_normal(points, t));
}

}  // namespace rimline
