// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of the selected triangles as loops.
#pragma once

#include <vector>

#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"
#include "surface/components.h"

namespace rimline {

// All rims as loops, each with its component, its length and its probability to be a boundary; kinds are not
// known yet.
std::vector<Loop> trace_loops(const RimEvidence& evidence, const Components& components, const Run& run);

}  // namespace rimline
