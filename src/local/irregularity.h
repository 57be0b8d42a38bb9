// SPDX-License-Identifier: GPL-3.0-or-later
// Whether points are uniformly random or evenly spaced.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// Distances of a point to its neighbours.
struct Distances {
  double nearest = 0;   // to the nearest over the spacing
  double crowding = 0;  // spacing over the distance to the twelfth; 0 where there is none
  double reach = 0;     // logarithm of the distance to the twelfth over that to the fortieth, or the last
};
Distances measure_distances(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                            Index point);

// Coefficient of variation (standard deviation over mean) of the distances to the nearest neighbour over the
// spacing.
double variation_of_nearest(const std::vector<Distances>& distances);

// 1 for uniformly random points, 0 for evenly spaced ones, as scans and meshes have them. For random points
// the distance to the nearest neighbour has a standard deviation of 0.4 of its mean over the spacing, and the
// spacing is 0.506 of the distance of the twelfth neighbour; for even points these are 0.25 and 0.55, with
// noise included. Noise makes the steps along scan lines vary like those of random points, but moves no point
// far: on samples of 1,000 points the ratio of the distances of the twelfth and the fortieth neighbour varies
// by at least 0.88 of what random points are expected to have where points are random, and by at most 0.74 on
// scan lines, with noise of half a step included. `k`: length of the lists of neighbours; 0 where they are
// too short.
double irregularity(const std::vector<Distances>& distances, int k);

}  // namespace rimline
