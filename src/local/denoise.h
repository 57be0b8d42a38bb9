// SPDX-License-Identifier: GPL-3.0-or-later
// Noise removal: points are projected onto the local quadric.
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

// The denoised points, on which all later geometry is based. None where the sampling has no noise, or where
// two denoised points coincide.
std::optional<DenoisedPoints> denoise(Points points, const Neighbours& neighbours,
                                      const SamplingProfile& sampling, const Run& run);

}  // namespace rimline
