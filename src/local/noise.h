// SPDX-License-Identifier: GPL-3.0-or-later
// How far the points lie off a smooth surface, and where they would be without that.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// What scatters the points about the surface and its rims.
struct NoiseModel {
  double noise = 0;      // standard deviation of the points over the spacing
  double irregular = 0;  // 1 where points are strewn at random, 0 where they keep apart
  bool anisotropic =
      false;  // whether points lie closer in one direction than in another, as along scan lines
};

// How far the neighbours of a point lie off the quadric through the 12 nearest: standard deviation over the
// spacing.
double quadric_deviation(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         Index point);

// The standard deviation of the points across the surface, over the spacing; above 0 even for exact points of
// a curved surface. From the deviations at some points. Their lower quartile is asked: noise is everywhere,
// while creases and relief that the quadrics can not follow are at some places only. On coarse points of a
// strongly curved surface these are most places, so the lower twentieth must tell nearly the same noise as
// the quartile; less of it is relief, and the level falls to 0, unless points lie as close together as noise,
// misregistered scans and chance have them. `variation_of_nearest`: of the nearest distances over the
// spacing, standard deviation over mean.
double noise_level(std::vector<double> deviations, double variation_of_nearest);

// How much of the noise is to be heeded, in [0, 1]: nothing of what the quadrics leave on clean scans.
double noise_weight(double level);

// The points moved along their normals by `weight` of the way to the quadric through the 24 nearest.
std::vector<Point> take_off_noise(Points points, const Neighbours& neighbours, double weight, const Run& run);

}  // namespace rimline
