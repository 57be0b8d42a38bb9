// SPDX-License-Identifier: GPL-3.0-or-later
// Results in the order and ids of the input.
#pragma once

#include <vector>

#include "pipeline/method.h"
#include "pipeline/prepare.h"
#include "rimline/score_boundary.h"
#include "rimline/seams.h"

namespace rimline::pipeline {

// Translates one value per vertex to one per point of the input, then per added vertex; NaN or `none` for
// points not in use. Patches are empty where there is only one.
std::vector<UV> uv_of_input(const PreparedPoints& prepared, const std::vector<UV>& uv);
std::vector<Index> patch_of_input(const PreparedPoints& prepared, const std::vector<Index>& patch);
Distortion distortion_of_input(const PreparedPoints& prepared, Distortion distortion);

std::vector<Point> added_points(const PreparedPoints& prepared, const MappedMesh& mesh);
std::vector<Triangle> triangles_of_input(const PreparedPoints& prepared, std::vector<Triangle> triangles);
Seams seams_of_input(const PreparedPoints& prepared, Seams seams);

// The loops and the results of each point. `label` is that of the loops; the report is left empty.
BoundaryResult boundary_of_input(const PreparedPoints& prepared, const BoundaryScores& scores,
                                 const FoundLoops& found, const std::vector<PointLabel>& label,
                                 std::vector<Loop> loops, const LoopOptions& options, const Run& run);

}  // namespace rimline::pipeline
