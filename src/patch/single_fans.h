// SPDX-License-Identifier: GPL-3.0-or-later
// Removes pinches: vertices at which a surface touches itself.
#pragma once

#include <span>

#include "mesh/editable_mesh.h"

namespace rimline {

// Leaves one fan at each vertex. Two fans of one component are joined by a triangle between them where one
// fits the surface (a narrow angle, edges of a few spacings, no fold); otherwise the fan with most triangles
// stays and the others are removed. Where components touch, the vertex stays with the fan of most triangles.
// `spacing`: one per vertex.
void leave_single_fans(EditableMesh& mesh, std::span<const double> spacing);

}  // namespace rimline
