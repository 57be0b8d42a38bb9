// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages require of their caller: the library does not check it again, Python must not be able to
// break it.
#pragma once

#include <fmt/format.h>
#include <nanobind/nanobind.h>

#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline::python {

// Raises ValueError, naming the argument.
inline void check_size(std::size_t size, std::size_t wanted, const char* what) {
  if (size == wanted) return;
  throw nanobind::value_error(
      fmt::format("{} is for {} points, but there are {}", what, size, wanted).c_str());
}

inline void check_finite(Points points) {
  for (const Point p : points) {
    if (!is_finite(p)) throw nanobind::value_error("points must be finite; arrange() leaves others out");
  }
}

// Finite points, and lists of as many.
inline void check_neighbours(Points points, const Neighbours& neighbours) {
  check_finite(points);
  check_size(static_cast<std::size_t>(neighbours.size()), points.size(), "neighbours");
}

// Likewise, and no two at the same place: the nearest neighbour of such a point is at distance 0.
inline void check_distinct(Points points, const Neighbours& neighbours) {
  check_neighbours(points, neighbours);
  for (Index i = 0; i < neighbours.size(); ++i) {
    if (distance_to(points, neighbours, i, 0) > 0) continue;
    throw nanobind::value_error("points must be distinct; arrange() leaves repeated ones out");
  }
}

// Ids in range, three different ones a triangle.
inline void check_triangles(const std::vector<Triangle>& triangles, std::size_t point_count) {
  for (const auto& [a, b, c] : triangles) {
    for (const Index v : {a, b, c}) {
      if (v < 0 || static_cast<std::size_t>(v) >= point_count)
        throw nanobind::value_error(
            fmt::format("a triangle has the id {}; there are {} points", v, point_count).c_str());
    }
    if (a == b || b == c || c == a)
      throw nanobind::value_error(fmt::format("a triangle has the id {} twice", a == b ? a : c).c_str());
  }
}

}  // namespace rimline::python
