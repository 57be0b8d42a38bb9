// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves: in the order and ids of the input, with the report.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Fills the report's part on the mesh.
void measure(Work& work);

std::vector<UV> uv_of_input(const Work& work);
std::vector<Index> patch_of_input(const Work& work);
std::vector<Triangle> triangles_of_input(const Work& work);

// The loops, what is known of each point, and the report. Takes them out of `work`: the last call.
BoundaryResult boundary_result(Work& work);

}  // namespace rimline::pipeline
