// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a rim of the selected triangles is a boundary of the surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "local/samples.h"
#include "local/sampling_profile.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// The data by which rims are judged. Holds references that must outlive it.
struct RimEvidence {
  const TriangleSet& set;
  const Selection& selection;
  // Per point, 1 where it became a rim point when a false ear was removed: empty balls there are as narrow as
  // the gaps between samples and tell nothing. Empty where none was removed.
  std::span<const std::uint8_t> behind_false_ear;
  const Samples& samples;
  const SamplingProfile& sampling;
};

// Features that tell a boundary from the end of the triangulation.
struct RimMeasures {
  double empty_ball = 0;  // median radius over its edges, in spacings; those at false ears do not count
  double thickness = 0;   // mean of the frames along it, less what a small opening under noise bends
  bool is_known = false;  // false where all edges are at false ears
};
RimMeasures measure_rim(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

// The same of a range image: mean length of the mean_direction() of the rim's points, 0 to 1.
double mean_one_sided(const std::vector<Index>& rim, const Samples& samples);

// Probability in [0, 1] that the surface ends at the rim, and not just the triangulation, at a crease or a
// thin wall: by the number of its points, the empty balls beyond its edges and the thickness of the frames
// along it.
double rim_probability(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

// The same, reduced where the rim is no wider than the gap between two neighbours, as at density borders.
double boundary_probability(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

}  // namespace rimline
