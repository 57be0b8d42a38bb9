// SPDX-License-Identifier: GPL-3.0-or-later
// The default method in place of section 5: from loops to map and mesh. [ours]
#pragma once

#include "pipeline/method.h"

namespace rimline::pipeline {

// Meshes each component as a patch, with its holes kept, refined by flips in space. Throws NoClosedLoop
// without loops, and what refine_surface() throws.
MappedMesh mesh_patches(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                        const Given& given, const Run& run, StageClock& clock);

}  // namespace rimline::pipeline
