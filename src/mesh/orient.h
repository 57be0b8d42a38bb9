// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the orientation of triangles consistent.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Turns triangles so that neighbours run along their edge in opposite directions, starting from the first of
// each component. Each edge may have two triangles at most. Returns false for a one-sided surface; neighbours
// then agree along the walk from the first.
bool orient_alike(std::vector<Triangle>& triangles);

// Reverses each loop that runs against the triangles at its edges.
void turn_loops_along(const std::vector<Triangle>& triangles, std::vector<Loop>& loops);

}  // namespace rimline
