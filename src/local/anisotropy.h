// SPDX-License-Identifier: GPL-3.0-or-later
// Anisotropy of the sampling: how much closer points lie in one direction than in another, as along and
// across scan lines.
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

// The metric in which the offsets to near neighbours (in units of about the spacing, from any number of
// points) are isotropic. Close neighbours have the largest weights. The identity where there are none.
Anisotropy find_anisotropy(const std::vector<Offset>& offsets);

// Logarithm of the ratio of the densities along the two axes of the metric; 0 for an isotropic sampling.
double log_ratio(const Anisotropy& anisotropy);

// The same at a point, from its neighbours and their neighbours.
double anisotropy_at(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                     Index point);

// The mean of that over some points, or 0 where it is explained by chance or by the strips of a mesh. Random
// points have at most 0.7, the mesh of a scanned man 0.87, scan lines 1.1 or more, even with noise of half a
// step.
double mean_anisotropy(const std::vector<double>& at_points);

}  // namespace rimline
