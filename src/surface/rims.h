// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a set of triangles, as closed polylines.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/triangle_set.h"

namespace rimline {

// Which triangles of a set are in: one byte each.
using Selection = std::vector<std::uint8_t>;

// The selected triangle at an edge, the first of two; or none.
Index selected_triangle(const TriangleSet& set, const Selection& selected, Index a, Index b);

// Three selected triangles' worth of walking around a vertex: the fan that holds triangle t, from t's edge
// (vertex, from) to its far end. Returns the last triangle; `end` is the vertex of its free edge, or `from`
// again where the fan closes.
Index walk_fan(const TriangleSet& set, const Selection& selected, Index vertex, Index t, Index from,
               Index& end);

// The loops of the selected triangles' rim, each simple: a rim that meets itself in a pinch is split there.
// Each is directed as the triangle at its first edge is oriented (surface on the left).
std::vector<std::vector<Index>> walk_rims(const TriangleSet& set, const Selection& selected,
                                          const Run& run = {});

}  // namespace rimline
