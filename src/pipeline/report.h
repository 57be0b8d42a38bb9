// SPDX-License-Identifier: GPL-3.0-or-later
// Assembles the report from the results of the stages. Warnings are in the order of the stages.
#pragma once

#include "pipeline/measure.h"
#include "pipeline/method.h"

namespace rimline::pipeline {

// The report on the input, the test and the search. Loops and costs are added by finish().
Report report_boundary(const PreparedPoints& prepared, const BoundaryScores& scores, const FoundLoops& found,
                       const Options& options, const Run& run);

// Adds the map.
Report add_map(Report report, const MappedMesh& mesh);

// Adds the mesh and its measures.
Report add_measures(Report report, const Measures& measures);

// Adds the loops of the result, the number of undersampled points, and the costs of the stages.
Report finish(Report report, const BoundaryResult& result, const Run& run, StageClock& clock);

}  // namespace rimline::pipeline
