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
  TriangleSet set;      // the proposed triangles but for some that are out, and missing ears
  Selection selection;  // of these
  SelectionSummary summary;
};

// The genetic search (search/selection_search.h), four times over: first as nothing is known of the rims;
// then again where they turned out to be even; then, the large triangles out of the way and missing ears
// filled, once more over what is left; and for single ears along its rims, with a fitness that was fitted
// there, of which short runs are taken over. Of a range image all triangles are the surface.
SelectedSurface select(TriangleSet proposed, const Samples& samples, const SamplingProfile& sampling,
                       const BoundaryLoopOptions& options, const Run& run);

// Marks the points of rims that are no boundary, as all triangles stand: at creases and thin walls stars do
// not agree and leave gaps, which the search would only tear open.
std::vector<std::uint8_t> find_excluded(const TriangleSet& set, const Samples& samples,
                                        const SamplingProfile& sampling, const Run& run);

}  // namespace rimline
