// SPDX-License-Identifier: GPL-3.0-or-later
// Outliers: single points beside a surface that is complete without them.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Marks (1) the points that lie off the surface of their neighbours by more than their noise, and the noise
// of nine tenths of all points, explains, with hardly any others off it nearby: those would be another sheet.
// `scale`: usual_spacing().
std::vector<char> lies_off_surface(Points points, const Neighbours& neighbours,
                                   const std::vector<double>& scale, const Run& run);

}  // namespace rimline
