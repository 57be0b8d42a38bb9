// SPDX-License-Identifier: GPL-3.0-or-later
// How much closer points lie in one direction than in another, as along and across scan lines.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// A symmetric positive matrix of determinant 1: squared lengths are xx x^2 + 2 xy x y + yy y^2.
struct Anisotropy {
  double xx = 1, xy = 0, yy = 1;
};

struct Offset {
  double x, y;
};

// Under which points lie alike in all directions: offsets to near neighbours, in units of about the spacing,
// from any number of points. Close ones count most. The identity where there are none.
Anisotropy find_anisotropy(const std::vector<Offset>& offsets);

// Logarithm of how much closer points lie one way than the other, e^(r/2) and e^(-r/2) of alike in all
// directions; 0 where they lie about alike.
double log_ratio(const Anisotropy& anisotropy);

// The same at a point, from its neighbours and theirs.
double anisotropy_at(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                     Index point);

// The mean of that at some points; 0 where it is no more than chance or the strips of a mesh bring about.
// Random points have 0.7 at most, a scanned man's mesh 0.87, scan lines 1.1 or more, noise of half a step and
// all.
double mean_anisotropy(const std::vector<double>& at_points);

}  // namespace rimline
