// SPDX-License-Identifier: GPL-3.0-or-later
// Removes filled holes from the boundary.
#pragma once

#include <vector>

#include "pipeline/mapped_mesh.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {

// The mesh without the loops that were filled; their points are no longer labelled boundary. With a summary
// of all holes.
MappedMesh take_out_filled(MappedMesh mesh, const std::vector<PatchReport>& patches);

}  // namespace rimline::pipeline
