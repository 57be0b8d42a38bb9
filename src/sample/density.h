// SPDX-License-Identifier: GPL-3.0-or-later
// The density of points, and so the spacing.
#pragma once

#include <algorithm>
#include <cmath>

#include "sample/surface.h"

namespace rimline {

enum class DensityChange { None, Smooth, Step };

// The spacing of a sampling is 1 / sqrt(points per unit of area).
struct Density {
  DensityChange change = DensityChange::None;
  double spacing = 0;  // where the relative density is 1, the least there is

  // From 10 down to 1 across the surface: as 10^(1 - t), or 10 in the first half and 1 in the second.
  double relative(const AnalyticSurface& surface, UV at) const {
    switch (change) {
      case DensityChange::None: return 1;
      case DensityChange::Smooth: return std::pow(10, 1 - std::clamp(surface.across(at), 0.0, 1.0));
      case DensityChange::Step: return surface.across(at) < 0.5 ? 10 : 1;
    }
    return 1;
  }
  double spacing_at(const AnalyticSurface& surface, UV at) const {
    return change == DensityChange::None ? spacing : spacing / std::sqrt(relative(surface, at));
  }
};

// Integrals over a surface, by the midpoint rule.
struct Extent {
  double chart_area = 0;       // of the part of the chart that is kept
  double area = 0;             // of the surface
  double weighted_area = 0;    // times the relative density
  double largest_stretch = 0;  // an upper bound of Tangents::area() on the surface
};
Extent measure(const AnalyticSurface& surface, const Density& density);

}  // namespace rimline
