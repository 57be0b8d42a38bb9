// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface was sampled: what is judged over the whole of it.
#pragma once

#include <span>
#include <vector>

#include "base/model.h"
#include "local/irregularity.h"
#include "local/noise.h"
#include "local/point_sample.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct SamplingProfile {
  NoiseModel noise;             // none where the points are clean
  double noise_weight = 0;      // share of the noise that is taken off the points, in [0, 1]
  bool is_range_image = false;  // the points are a scanner's raster; nothing else is asked then

  // Whether points are so nearly random that rims look jagged by chance.
  bool is_random() const { return noise.irregular >= model::is_random; }
};

inline SamplingProfile of_range_image() {
  SamplingProfile profile;
  profile.is_range_image = true;
  return profile;
}

// What is measured at one point.
struct SamplingMeasures {
  double deviation = 0;  // off a quadric, over the spacing
  Distances distances;
};

// What the profile is made of: measures at up to 4,096 points and anisotropy at up to 256 of these. Of a part
// of the points that has the same neighbours and spacings as in the whole; samples of parts that share no
// point add up to that of the whole, and give the same profile.
struct SamplingSample {
  PointSample<SamplingMeasures> measures;
  PointSample<double> anisotropy;
  int k = 0;  // length of the lists of neighbours

  SamplingSample& operator+=(const SamplingSample& other);
};

// `part`: the points that are taken, by id.
SamplingSample sample_sampling(Points points, std::span<const Index> part, const Neighbours& neighbours,
                               const std::vector<double>& spacing, const Run& run);
SamplingProfile profile_of(const SamplingSample& sample);

// The profile of all points, which are no range image. Measures anisotropy only where it is asked for.
SamplingProfile profile_sampling(Points points, const Neighbours& neighbours,
                                 const std::vector<double>& spacing, const Run& run);

}  // namespace rimline
