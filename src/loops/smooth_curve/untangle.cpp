// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/untangle.h"

#include <cstddef>
#include <utility>

namespace rimline {

std::vector<RimSample> untangle(Points points, std::vector<RimSample> loop) {
  constexpr std::size_t longest = 8;  // [speed]
  constexpr int sweeps = 10;          // [guard]
  const std::size_t n = loop.size();
  if (n < 3 * longest) return loop;
  const auto at = [&](std::size_t i) -> RimSample& { return loop[i % n]; };
  const auto length = [&](std::size_t i, std::size_t j, Point normal) {
    const Point d = points[at(j).point] - points[at(i).point];
    return norm(d - dot(d, normal) * normal);
  };
  bool again = true;
  for (int sweep = 0; sweep < sweeps && again; ++sweep) {
    again = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < i + longest; ++j) {  // the stretch from i + 1 to j
        const Point normal = at(i).normal;
        const double before = length(i, i + 1, normal) + length(j, j + 1, normal);
        if (length(i, j, normal) + length(i + 1, j + 1, normal) >= before * (1 - 1e-9)) continue;  // [guard]
        for (std::size_t a = i + 1, b = j; a < b; ++a, --b) std::swap(at(a), at(b));
        again = true;
      }
    }
  }
  return loop;
}

}  // namespace rimline
