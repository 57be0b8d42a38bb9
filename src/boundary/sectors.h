// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (1): how evenly angles spread over equal sectors.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// The number of points whose angle about the origin lies in each of `sectors` equal slices of [0, 2 pi),
// the first of which starts at the first axis. A point at the origin counts as angle 0.
void count_sectors(std::span<const UV> image, int sectors, std::vector<int>& counts);

// Pearson's statistic, eq. (1), of the counts.
double pearson_statistic(std::span<const int> counts);

}  // namespace rimline
