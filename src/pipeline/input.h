// SPDX-License-Identifier: GPL-3.0-or-later
// What came in: checked, arranged, its neighbours found.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Throws BadOption for options out of range, normals that are not one per point, and given loops that name
// points which the input does not have.
void check_input(const Work& work);

// Fills the arrangement, the neighbours and the spacing.
void prepare(Work& work);

}  // namespace rimline::pipeline
