// SPDX-License-Identifier: GPL-3.0-or-later
// The scale at which the surface was sampled around each point.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The scale of each point: the median spacing of the points around it. An outlier gets the scale of the
// surface beside it, whatever its own distance is.
std::vector<double> usual_spacing(const Neighbours& neighbours, const std::vector<double>& spacing,
                                  const Run& run);

}  // namespace rimline
