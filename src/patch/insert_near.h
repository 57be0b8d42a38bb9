// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the surface that no triangle has.
#pragma once

#include <span>

#include "mesh/editable_mesh.h"
#include "rimline/neighbours.h"

namespace rimline {

// Splits, for each vertex that no triangle has, the triangle of its neighbours' that it lies over, where it
// lies within `farthest` spacings of it. Those beside the surface, or farther off, stay out.
void insert_near(EditableMesh& mesh, const Neighbours& neighbours, std::span<const double> spacing);

}  // namespace rimline
