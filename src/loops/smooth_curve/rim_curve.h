// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth closed curve along a rim: moving least squares in the curve's parameter.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "local/anisotropy.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// A point of the rim.
struct RimSample {
  double t;  // along the rim, in [0, period): about one a point
  Index point;
  Point normal;  // of the surface there; unit length
};

// A point of the curve, with the surface behind it.
struct Knot {
  Point at, along, out, normal;  // the directions are unit vectors; `out` leaves the surface
  double step;                   // length of one unit of t
  double spacing;                // of the points here
  double along_density = 1;      // density along the curve relative to an isotropic sampling
  double out_density = 1;        // and across it
};

// Two knots for each unit of t.
class RimCurve {
 public:
  RimCurve(double period, std::vector<Knot> knots) : period_(period), knots_(std::move(knots)) {}

  double period() const { return period_; }
  std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(knots_.size()); }
  const Knot& knot(std::size_t i) const { return knots_[i]; }
  double t_of(std::size_t i) const { return period_ * static_cast<double>(i) / static_cast<double>(size()); }
  // The knot of an index that is off by at most one period.
  std::size_t wrap(std::ptrdiff_t i) const {
    return static_cast<std::size_t>(i < 0 ? i + size() : i < size() ? i : i - size());
  }

  // The expected number of points of a rim here, at one point per squared spacing.
  double point_count() const { return running_count().back(); }
  // The same from the first knot to each, and for the full period.
  std::vector<double> running_count() const;
  // Area, in square spacings, of a strip along the curve that is one spacing wide and lies `depth` spacings
  // inwards.
  double strip(double depth) const;

  // The same curve with densities at its knots, measured from offsets to near neighbours: at positions t,
  // ascending, along the curve and outwards, in spacings.
  RimCurve with_densities(const std::vector<std::pair<double, Offset>>& offsets, const Run& run) const;

 private:
  double period_;
  std::vector<Knot> knots_;
};

// Fits the samples, which ascend by t, by quadratics in t over `window` units to either side, with tricube
// weights (Cleveland 1979, Robust locally weighted regression: LOESS). None where the samples are too few.
std::optional<RimCurve> fit_rim_curve(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing,
                                      const std::vector<RimSample>& samples, double period, double window,
                                      const Run& run);

}  // namespace rimline
