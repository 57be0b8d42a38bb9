// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/density.h"

namespace rimline {

Extent measure(const AnalyticSurface& surface, const Density& density) {
  constexpr int steps = 128;
  Extent extent;
  const double du = surface.box.width() / steps, dv = surface.box.height() / steps;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const UV at{surface.box.low.u + (i + 0.5) * du, surface.box.low.v + (j + 0.5) * dv};
      const double stretch = surface.tangents(at).area();
      extent.largest_stretch = std::max(extent.largest_stretch, stretch);
      if (surface.depth(at) <= 0) continue;
      extent.chart_area += du * dv;
      extent.area += stretch * du * dv;
      extent.weighted_area += density.relative(surface, at) * stretch * du * dv;
    }
  }
  // The largest value lies between the nodes: within this of it, for slopes as gentle as ours.
  extent.largest_stretch *= 1.02;
  return extent;
}

}  // namespace rimline
