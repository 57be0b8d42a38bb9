// SPDX-License-Identifier: GPL-3.0-or-later
// Removes the false ears (teeth) of jagged rims.
#pragma once

#include <cstdint>
#include <vector>

#include "evidence/corner_histogram.h"
#include "local/samples.h"
#include "local/sampling_profile.h"
#include "rimline/options.h"
#include "search/select.h"
#include "surface/local_size.h"

namespace rimline {

// A false ear is a selected triangle with an edge on a jagged rim whose third corner is more likely on the
// boundary than not. The search, which weighs sizes and turning, keeps it, because on an even rim nearly all
// such triangles belong to the surface.
struct WithoutFalseEars {
  Selection selection;
  std::vector<std::uint8_t> behind;  // per point, 1 where it was the third corner of one; or empty
  CornerHistogram corners;           // on the surface behind the rims
};

// Removes the false ears of the rims that are boundaries, two layers deep, the most probable of each layer
// first. Not for random points or under noise, where rims look jagged by chance, nor for range images.
WithoutFalseEars remove_false_ears(const SelectedSurface& surface, const LocalSizes& sizes,
                                   const Samples& samples, const SamplingProfile& sampling,
                                   const BoundaryLoopOptions& options, const Run& run);

}  // namespace rimline
