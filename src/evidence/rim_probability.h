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

// What rims are judged by. All of it must outlive it.
struct RimEvidence {
  const TriangleSet& set;
  const Selection& selection;
  // Per point, 1 where it came to lie on a rim as a false ear was removed: empty balls there are as narrow as
  // the gaps between samples and say nothing of what lies beyond. Empty where none was.
  std::span<const std::uint8_t> behind_false_ear;
  const Samples& samples;
  const SamplingProfile& sampling;
};

// What tells a boundary from the end of what could be triangulated.
struct RimMeasures {
  double empty_ball = 0;  // median radius over its edges, in spacings; those at false ears do not count
  double thickness = 0;   // mean of the frames along it, less what a small opening under noise bends
  bool is_known = false;  // false where all edges are at false ears
};
RimMeasures measure_rim(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

// That the rim is where the surface ends and not where the triangles happen to, at a crease or a thin wall:
// by the number of its points, the empty balls beyond its edges and the thickness of the frames along it. In
// [0, 1].
double rim_probability(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

// The same, less where the rim is no wider than the gap between two neighbours, as rims at density borders
// are.
double boundary_probability(const std::vector<Index>& rim, const RimEvidence& evidence, const Run& run);

}  // namespace rimline
