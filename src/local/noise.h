// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the noise of the points and removes it.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Model of the scatter of the points about the surface and its rims.
struct NoiseModel {
  double noise = 0;      // standard deviation of the points over the spacing
  double irregular = 0;  // 1 where points are random, 0 where they are evenly spaced
  bool anisotropic =
      false;  // whether points lie closer in one direction than in another, as along scan lines
};

// Standard deviation, over the spacing, of the neighbours of a point from the quadric through the 12 nearest.
double quadric_deviation(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         Index point);

// The standard deviation of the points across the surface, over the spacing; above 0 even for exact points of
// a curved surface. Estimated from the deviations at some points, by their lower quartile: noise is
// everywhere, while creases and relief that quadrics can not follow are local. On coarse points of a strongly
// curved surface relief is nearly everywhere, so the lower twentieth must give nearly the same noise as the
// quartile. Where it gives less, the deviations are relief and the level falls to 0, unless points lie as
// close together as under noise, misregistration or chance. `variation_of_nearest`: coefficient of variation
// of the nearest distances over the spacing.
double noise_level(std::vector<double> deviations, double variation_of_nearest);

// The share of the noise that is removed, in [0, 1]: 0 up to the level that quadrics leave on clean scans.
double noise_weight(double level);

// The points moved along their normals by `weight` of the way to the quadric through the 24 nearest.
std::vector<Point> take_off_noise(Points points, const Neighbours& neighbours, double weight, const Run& run);

}  // namespace rimline
