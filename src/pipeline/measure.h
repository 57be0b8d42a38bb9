// SPDX-License-Identifier: GPL-3.0-or-later
// The report's part on the mesh.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Measures the whole, each component, and the distance to the reference where there is one.
void measure(Work& work);

}  // namespace rimline::pipeline
