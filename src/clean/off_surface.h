// SPDX-License-Identifier: GPL-3.0-or-later
// Outliers: single points beside a surface that goes on without them.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The points, 1 where true, that lie off the surface of their neighbours by more than their noise, and that
// of nine tenths of all points, explains, and beside which there are hardly others off it: those would be
// another sheet. `scale`: usual_spacing().
std::vector<char> lies_off_surface(Points points, const Neighbours& neighbours,
                                   const std::vector<double>& scale, const Run& run);

}  // namespace rimline
