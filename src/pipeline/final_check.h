// SPDX-License-Identifier: GPL-3.0-or-later
// The arrays that leave, checked on every run.
#pragma once

#include "pipeline/mapped_mesh.h"
#include "rimline/run.h"

namespace rimline::pipeline {

// Leaves out what is not valid, with a warning: the map of a component that turns a triangle over or leaves
// it no area, and a component that is no manifold or does not end at its loops (fault_of). Requires
// components.
MappedMesh checked(MappedMesh mesh, const Run& run);

}  // namespace rimline::pipeline
