// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Moves each point by isotropic Gaussian noise: each coordinate by a standard deviation of `deviation` local
// mean nearest-neighbour distances.
void add_noise(std::vector<Point>& points, double deviation, const Run& run);

// The distance to the nearest neighbour, averaged over each point and its eight nearest.
std::vector<double> local_nearest_distance(Points points, const Run& run);

}  // namespace rimline
