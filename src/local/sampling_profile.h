// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the sampling that are judged over the whole surface.
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
  double noise_weight = 0;      // share of the noise that is removed, in [0, 1]
  bool is_range_image = false;  // the points are a range image; nothing else is measured then

  // Whether points are so nearly random that rims look jagged by chance.
  bool is_random() const { return noise.irregular >= model::is_random; }
};

inline SamplingProfile of_range_image() {
  SamplingProfile profile;
  profile.is_range_image = true;
  return profile;
}

// Measures at one point.
struct SamplingMeasures {
  double deviation = 0;  // off a quadric, over the spacing
  Distances distances;
};

// A sample from which the profile is computed: measures at up to 4,096 points, and anisotropy at up to 256 of
// these. It can be taken of a part of the points, with the neighbours and spacings of the whole. Samples of
// disjoint parts, added up, give the profile of the whole.
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

// The profile of all points, which must not be a range image. Anisotropy is measured only where it is needed.
SamplingProfile profile_sampling(Points points, const Neighbours& neighbours,
                                 const std::vector<double>& spacing, const Run& run);

}  // namespace rimline
