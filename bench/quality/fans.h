// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline::bench {

// Vertices whose triangles do not form one fan: the edges opposite to the vertex fall into several pieces.
std::size_t count_nonmanifold_vertices(const std::vector<Triangle>& mesh);

}  // namespace rimline::bench
