// SPDX-License-Identifier: GPL-3.0-or-later
// The points near a rim, projected to its smooth curve.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "loops/smooth_curve/rim_curve.h"

namespace rimline {

// The position of a point relative to the curve.
struct Projection {
  Index point = none;
  double t = 0;    // along the curve, in [0, period)
  double out = 0;  // signed distance from the curve, in spacings (times the density across it); inside < 0
  std::size_t knot = 0;
  double squared_distance = std::numeric_limits<double>::infinity();  // to the nearest knot
  Point normal = {};
  bool is_sample = false;  // one of the rim's own points
};

// The samples and their neighbours, each projected at its nearest knot. Points more than a spacing off the
// surface behind the curve are left out. In the order in which the samples name them.
std::vector<Projection> project(const RimCurve& curve, Points points, const Neighbours& neighbours,
                                const std::vector<RimSample>& samples, const Run& run);

// Offsets from the points right behind the curve to their neighbours, along it: what
// RimCurve::with_densities() is told by.
std::vector<std::pair<double, Offset>> offsets_behind(const RimCurve& curve,
                                                      const std::vector<Projection>& projections,
                                                      Points points, const Neighbours& neighbours);

// The outermost first; ties by id.
std::vector<Projection> from_outermost(std::vector<Projection> projections, const Run& run);

// The first `count` projections as samples, along the curve.
std::vector<RimSample> along_curve(const std::vector<Projection>& projections, std::size_t count);

}  // namespace rimline
