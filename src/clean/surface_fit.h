// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that the neighbours of a point lie on, the point itself not asked.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

struct SurfaceFit {
  double height = 0;       // of the point over the surface, at least 0, over the scale
  double deviation = 0;    // of the neighbours that lie on it: robust standard deviation, over the scale
  double nearest = 1e300;  // along the surface, of those that lie on it, over the scale
  double gap = 0;          // widest angle between directions to those of them that are near, in radians
  int others = 0;          // near neighbours that lie off it, too
};

// The scale of each point: the median spacing of the points around it. An outlier gets that of the surface it
// is beside, whatever its own distance is.
std::vector<double> usual_spacing(const Neighbours& neighbours, const std::vector<double>& spacing,
                                  const Run& run);

// How far the point is off the plane through its nearest neighbours, over the scale: quick, and not robust.
double height_over_plane(Points points, const Neighbours& neighbours, Index self, double scale);

// Fits a quadric over a plane to the neighbours, both by iteratively reweighted least squares with Tukey's
// biweight (Beaton & Tukey 1974), so that other outliers and other sheets among the neighbours do not count.
SurfaceFit fit_without(Points points, const Neighbours& neighbours, Index self, double scale);

// The same of offsets from a point, over its scale, the nearest first.
SurfaceFit fit_without(std::span<const Point> offsets);

}  // namespace rimline
