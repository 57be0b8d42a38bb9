// SPDX-License-Identifier: GPL-3.0-or-later
// How far the points lie off a smooth surface, and where they would be without that.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline::exact {

// The standard deviation of the points across the surface, over the spacing; above 0 even for exact points of
// a curved surface. From the residuals of quadrics through the 12 nearest neighbours of up to about 4,096
// points. Their lower quartile is asked: noise is everywhere, while creases and relief that the quadrics can
// not follow are at some places only. On coarse points of a strongly curved surface these are most places, so
// the lower twentieth must tell nearly the same noise as the quartile; less of it is relief, and the level
// falls to 0, unless points lie as close together as noise, misregistered scans and chance have them.
double noise_level(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                   const Run& run);

// How much of the noise is to be heeded, in [0, 1]: nothing of what the quadrics leave on clean scans.
double noise_weight(double level);

// Whether the points are strewn at random (1) or keep apart from each other (0), as scans and meshes do. At
// random the distance to the nearest neighbour varies by 0.4 of its mean over the spacing, and the six
// nearest are at 0.506 of the distance of the twelfth; where points keep apart it is 0.25 and 0.55, noise and
// all. Noise makes the steps along scan lines vary as at random, but it moves no point far: on samples of
// 1,000 points the distance of the twelfth over that of the fortieth varies by 0.88 and more of what is
// expected at random where points are so, and by 0.74 at most on scan lines, noise of half a step and all.
double irregularity(Points points, const Neighbours& neighbours, const std::vector<double>& spacing);

// The points moved along their normals by `weight` of the way to the quadric through the 24 nearest.
std::vector<Point> take_off_noise(Points points, const Neighbours& neighbours, double weight, const Run& run);

}  // namespace rimline::exact
