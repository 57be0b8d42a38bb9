// SPDX-License-Identifier: GPL-3.0-or-later
// The local surface of the neighbours of a point, fitted without the point.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

struct SurfaceFit {
  double height = 0;     // of the point over the surface, at least 0, over the scale
  double deviation = 0;  // robust standard deviation of the neighbours that lie on it, over the scale
  double nearest =
      1e300;       // distance along the surface to the nearest of those that lie on it, over the scale
  double gap = 0;  // widest angle between directions to those of them that are near, in radians
  int others = 0;  // number of near neighbours that lie off it, too
};

// Fits a quadric over a plane to the neighbours, both by iteratively reweighted least squares with Tukey's
// biweight (Beaton & Tukey 1974), so that other outliers and other sheets among the neighbours do not count.
SurfaceFit fit_without(Points points, const Neighbours& neighbours, Index self, double scale);

// The same of offsets from a point, over its scale, the nearest first.
SurfaceFit fit_without(std::span<const Point> offsets);

}  // namespace rimline
