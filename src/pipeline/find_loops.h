// SPDX-License-Identifier: GPL-3.0-or-later
// Sections 2 and 3, or ours in place of the latter: from points to loops.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Scores the points and fills the loops; under the preset `default` also probability, label and surveyed.
void find_loops(Work& work);

}  // namespace rimline::pipeline
