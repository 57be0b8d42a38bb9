// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/sampling_profile.h"

#include <cmath>

#include "local/anisotropy.h"
#include "local/irregularity.h"

namespace rimline {

SamplingProfile profile_sampling(Points points, const Neighbours& neighbours,
                                 const std::vector<double>& spacing, const Run& run) {
  constexpr double least_asked = 0.02;
  const double level = noise_level(points, neighbours, spacing, run);
  const double anisotropy = level > least_asked ? mean_anisotropy(points, neighbours, spacing, run) : 0;
  SamplingProfile profile;
  // Along scan lines points are closer than the spacing, so that less noise is much there.
  profile.noise_weight = noise_weight(level * std::exp(anisotropy / 2));
  profile.noise = {profile.noise_weight > 0 ? level : 0, irregularity(points, neighbours, spacing),
                   anisotropy > 0};
  return profile;
}

}  // namespace rimline
