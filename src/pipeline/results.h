// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves: in the order and ids of the input, with the report.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Per point of the input, then per vertex that fills added.
std::vector<UV> uv_of_input(const Work& work);
std::vector<Index> patch_of_input(const Work& work);
Distortion distortion_of_input(Work& work);  // takes it out of `work`

std::vector<Point> added_points(const Work& work);
std::vector<Triangle> triangles_of_input(const Work& work);

// The loops, what is known of each point, and the report. Takes them out of `work`: the last call.
BoundaryResult boundary_result(Work& work);

}  // namespace rimline::pipeline
