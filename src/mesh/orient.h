// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles turned so that neighbours agree.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// Turns triangles, of which each edge has two at most, so that neighbours run opposite ways along their edge,
// starting from the first of each component. False where that can not be: the surface is one-sided, and
// neighbours agree as far as the walk from the first came.
bool orient_alike(std::vector<Triangle>& triangles);

// Turns each loop round that runs against the triangles at its edges.
void turn_loops_along(const std::vector<Triangle>& triangles, std::vector<Loop>& loops);

}  // namespace rimline
