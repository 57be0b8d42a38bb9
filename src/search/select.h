// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the proposed triangles are the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "local/samples.h"
#include "local/sampling_profile.h"
#include "rimline/boundary_loops.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

struct SelectedSurface {
  TriangleSet set;      // the proposed triangles, without some that were left out, with missing ears
  Selection selection;  // of these
  SelectionSummary summary;
};

// Runs the genetic search (search/selection_search.h) four times: without knowledge of the rims; again where
// the rims found are even; a third time after large triangles are removed and missing ears added; and for
// ears along the rims, with weights of its own (RimFitnessModel), of which open_ears() takes over ears alone.
// Of a range image all triangles are the surface.
SelectedSurface select(TriangleSet proposed, const Samples& samples, const SamplingProfile& sampling,
                       const BoundaryLoopOptions& options, const Run& run);

// Marks the points on rims of all proposed triangles that are improbable as a boundary: at creases and thin
// walls stars do not agree and leave gaps, which the search would make larger.
std::vector<std::uint8_t> find_excluded(const TriangleSet& set, const Samples& samples,
                                        const SamplingProfile& sampling, const Run& run);

}  // namespace rimline
