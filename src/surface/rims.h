// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a set of triangles, as closed polylines.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/triangle_set.h"

namespace rimline {

// The selected triangles of a set: one byte each.
using Selection = std::vector<std::uint8_t>;

// The selected triangle at an edge, the first of two; or none.
Index selected_triangle(const TriangleSet& set, const Selection& selected, Index a, Index b);

// Walks the fan around a vertex, over selected triangles, from the edge (vertex, from) of triangle t to its
// other end. Returns the last triangle; `end` is the vertex at its free edge, or `from` where the fan closes.
Index walk_fan(const TriangleSet& set, const Selection& selected, Index vertex, Index t, Index from,
               Index& end);

// The loops of the selected triangles' rim, each simple: a rim that meets itself in a pinch is split there.
// Each is directed as the triangle at its first edge is oriented (surface on the left).
std::vector<std::vector<Index>> walk_rims(const TriangleSet& set, const Selection& selected,
                                          const Run& run = {});

}  // namespace rimline
