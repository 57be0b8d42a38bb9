// SPDX-License-Identifier: GPL-3.0-or-later
// The report, put together from what the stages gave. All warnings stand in the order of the stages.
#pragma once

#include "pipeline/measure.h"
#include "pipeline/method.h"

namespace rimline::pipeline {

// On the input, the test and the search. The loops and what the run took are added where it ends, by
// finish().
Report report_boundary(const PreparedPoints& prepared, const BoundaryScores& scores, const FoundLoops& found,
                       const Options& options, const Run& run);

// With the map.
Report add_map(Report report, const MappedMesh& mesh);

// With the mesh and its measures.
Report add_measures(Report report, const Measures& measures);

// With the loops of the result, which points are undersampled, and what the stages took.
Report finish(Report report, const BoundaryResult& result, const Run& run, StageClock& clock);

}  // namespace rimline::pipeline
