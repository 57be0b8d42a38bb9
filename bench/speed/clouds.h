// SPDX-License-Identifier: GPL-3.0-or-later
// The points that the stages are timed on.
#pragma once

#include <vector>

#include "rimline/points.h"

namespace rimline::bench {

// A wavy sheet over the unit square, sampled uniformly at random, in random order: an open surface whose
// spacing varies as that of random points does.
const std::vector<Point>& sheet(int count);

// The same in the order that arrange() gives.
const std::vector<Point>& arranged_sheet(int count);

}  // namespace rimline::bench
