// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that were filled are no boundary any more.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Takes the loops that were filled out of the loops, their points off the boundary, and reports what became
// of each hole.
void take_out_filled(Work& work, const std::vector<PatchReport>& patches);

}  // namespace rimline::pipeline
