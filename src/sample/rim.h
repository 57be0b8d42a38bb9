// SPDX-License-Identifier: GPL-3.0-or-later
// Walking the boundary curves evenly, and how near to them a point lies.
#pragma once

#include <functional>
#include <vector>

#include "sample/point_grid.h"
#include "sample/surface.h"

namespace rimline {

// The length of a short step from one place of the chart to another, in spacings.
using StepLength = std::function<double(UV from, UV to)>;

// Points on the rims, one list a rim, in order. Steps are equal along each arc and as close to `step`
// spacings as a whole number allows; the ends of arcs, which are corners, are points.
std::vector<std::vector<UV>> walk_rims(const AnalyticSurface& surface, const StepLength& length, double step);

// Finds out whether a place is within half a spacing of a boundary curve. The spacing may differ along a
// direction and across it.
class RimDistance {
 public:
  // `place` lays the chart out where distances are taken; `reach` is half the largest spacing there.
  RimDistance(const AnalyticSurface& surface, const StepLength& length, double reach,
              std::function<Point(UV)> place);

  bool within_half_spacing(UV at, double spacing) const {
    return within_half(at, spacing, spacing, {1, 0, 0});
  }
  // `along` and `across` are spacings, `direction` a unit vector that `along` belongs to.
  bool within_half(UV at, double along, double across, const Point& direction) const;

 private:
  std::function<Point(UV)> place_;
  PointGrid curve_;  // the curves, eight points a spacing: half a spacing is met to 1 %
};

}  // namespace rimline
