// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// Whether two triangles meet in more than the vertices that they share, with exact predicates. A triangle of
// no area meets none.
bool triangles_meet(Points points, Triangle s, Triangle t);

}  // namespace rimline
