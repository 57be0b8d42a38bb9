// SPDX-License-Identifier: GPL-3.0-or-later
// The arrays that leave, checked on every run.
#pragma once

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/run.h"

namespace rimline::pipeline {

// Leaves out what is not valid, with a warning: the map of a component that turns a triangle over or leaves
// it no area, and a component that is no manifold, shares a point with another or does not end at its loops
// (fault_of); this one is listed with its points in MappedMesh::left_out. Requires components.
MappedMesh checked(MappedMesh mesh, const PreparedPoints& prepared, const Run& run);

}  // namespace rimline::pipeline
