// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/self_intersections.h"

#include "rimline/measure.h"

namespace rimline::bench {

std::size_t count_self_intersections(Points points, const std::vector<Triangle>& mesh) {
  return find_self_intersections(points, mesh, {}).size();
}

}  // namespace rimline::bench
