// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include "mesh/components.h"
#include "mesh/orient.h"
#include "mesh/triangulation.h"

namespace rimline {

bool orient_alike(std::vector<Triangle>& triangles) {
  const Components components = find_components(link_triangles(triangles));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (components.turned[t]) std::swap(triangles[t][1], triangles[t][2]);
  }
  return std::ranges::count(components.orientable, 0) == 0;
}

void turn_loops_along(const std::vector<Triangle>& triangles, std::vector<Loop>& loops) {
  std::set<std::pair<Index, Index>> ahead;  // the first edge of each loop
  for (const Loop& loop : loops) ahead.emplace(loop.points[0], loop.points[1]);
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) ahead.erase({t[c], t[next(c)]});
  }
  for (Loop& loop : loops) {
    if (ahead.contains({loop.points[0], loop.points[1]}))
      std::reverse(loop.points.begin() + 1, loop.points.end());
  }
}

}  // namespace rimline
