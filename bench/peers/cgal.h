// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "peers/protocol.h"

namespace rimline::peers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline std::vector<Kernel::Point_3> to_cgal(const Coordinates& points) {
  std::vector<Kernel::Point_3> result;
  result.reserve(points.size());
  for (const auto& p : points) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

// Triangles of positions in `points`.
Answer advancing_front(const Coordinates& points);
Answer scale_space_alpha(const Coordinates& points);
Answer scale_space_advancing_front(const Coordinates& points);

}  // namespace rimline::peers
