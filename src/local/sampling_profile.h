// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface was sampled: what is judged over the whole of it.
#pragma once

#include <vector>

#include "local/noise.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct SamplingProfile {
  NoiseModel noise;             // none where the points are clean
  double noise_weight = 0;      // share of the noise that is taken off the points, in [0, 1]
  bool is_range_image = false;  // the points are a scanner's raster; nothing else is asked then

  // Whether points are so nearly random that rims look jagged by chance.
  bool is_random() const { return noise.irregular >= 0.5; }
};

inline SamplingProfile of_range_image() {
  SamplingProfile profile;
  profile.is_range_image = true;
  return profile;
}

// Of points that are no range image.
SamplingProfile profile_sampling(Points points, const Neighbours& neighbours,
                                 const std::vector<double>& spacing, const Run& run);

}  // namespace rimline
