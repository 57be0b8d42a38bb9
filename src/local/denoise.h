// SPDX-License-Identifier: GPL-3.0-or-later
// Points moved onto the surface, as far as their neighbours tell it.
#pragma once

#include <optional>
#include <vector>

#include "local/sampling_profile.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct DenoisedPoints {
  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<double> spacing;
};

// The points without their noise: all geometry under noise is that of these. None where the sampling has no
// noise, or two points came to lie in one place.
std::optional<DenoisedPoints> denoise(Points points, const Neighbours& neighbours,
                                      const SamplingProfile& sampling, const Run& run);

}  // namespace rimline
