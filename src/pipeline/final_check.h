// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the final arrays of every run.
#pragma once

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/run.h"

namespace rimline::pipeline {

// Removes what is not valid, with a warning: the map of a component with flipped triangles or triangles
// without area; and a component that is no manifold, shares a point with another or does not end at its loops
// (fault_of), which is listed with its points in MappedMesh::left_out. Requires components.
MappedMesh checked(MappedMesh mesh, const PreparedPoints& prepared, const Run& run);

}  // namespace rimline::pipeline
