// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts points on the surface that are in no triangle.
#pragma once

#include <span>

#include "mesh/editable_mesh.h"
#include "rimline/neighbours.h"

namespace rimline {

// For each vertex without a triangle, splits the triangle of its neighbours below it, if it is within
// `farthest` spacings of it. Vertices beside the surface, or farther away, stay out.
void insert_near(EditableMesh& mesh, const Neighbours& neighbours, std::span<const double> spacing);

}  // namespace rimline
