// SPDX-License-Identifier: GPL-3.0-or-later
// Ours in place of section 5: from loops to the map and the mesh at once.
#pragma once

#include "pipeline/method.h"

namespace rimline::pipeline {

// Each component its own patch, its holes kept, refined by flips in space. Throws NoClosedLoop where there
// are no loops, and as refine_surface() does.
MappedMesh mesh_patches(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                        const Given& given, const Run& run, StageClock& clock);

}  // namespace rimline::pipeline
