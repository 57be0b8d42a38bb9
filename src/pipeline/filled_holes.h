// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that were filled are no boundary any more.
#pragma once

#include <vector>

#include "pipeline/mapped_mesh.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {

// The mesh without the loops that were filled, their points no longer labelled boundary, and with a summary
// of what became of each hole.
MappedMesh take_out_filled(MappedMesh mesh, const std::vector<PatchReport>& patches);

}  // namespace rimline::pipeline
