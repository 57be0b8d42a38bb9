// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "base/vec.h"
#include "rimline/delaunay.h"

namespace rimline {

bool orient_mesh(Points points, std::vector<Triangle>& triangles, std::span<const Point> normals, Point up) {
  double agreement = 0;  // area times cosine, summed: large triangles count more
  for (const auto& [a, b, c] : triangles) {
    const Point facing = triangle_normal(points[a], points[b], points[c]);
    const Point wanted = normals.empty() ? up : normals[a] + normals[b] + normals[c];
    const double part = dot(facing, wanted);
    if (part == part) agreement += part;  // a normal may be NaN
  }
  if (agreement >= 0) return false;
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return true;
}

}  // namespace rimline
