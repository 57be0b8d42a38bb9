// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the proposed triangles are the surface.
#pragma once

#include "local/samples.h"
#include "local/sampling_profile.h"
#include "rimline/boundary_loops.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

struct SelectedSurface {
  TriangleSet set;      // the proposed triangles but for some that are out, and missing ears
  Selection selection;  // of these
  SelectionSummary summary;
};

// The genetic search (search/selection_search.h), three times over: first as nothing is known of the rims;
// then again where they turned out to be even; then, the large triangles out of the way and missing ears
// filled, once more over what is left. Of a range image all triangles are the surface.
SelectedSurface select(TriangleSet proposed, const Samples& samples, const SamplingProfile& sampling,
                       const BoundaryLoopOptions& options, const Run& run);

}  // namespace rimline
