// SPDX-License-Identifier: GPL-3.0-or-later
// The undirected edges of a list of triangles.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

struct Edge {
  Index a, b;     // a < b
  int triangles;  // how many triangles have it: 1 on the boundary, 2 inside, more where it is not manifold
};

// All edges once, ascending by (a, b).
std::vector<Edge> edges_of(const std::vector<Triangle>& triangles);

}  // namespace rimline
