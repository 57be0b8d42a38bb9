// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a set of triangles, as closed polylines.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/complex.h"

namespace rimline::exact {

// Which triangles of a complex are in: one byte each.
using Kept = std::vector<std::uint8_t>;

// The kept triangle at an edge, the first of two; or none.
Index kept_triangle(const Complex& complex, const Kept& kept, Index a, Index b);

// Three kept triangles' worth of walking around a vertex: the fan that holds triangle t, from t's edge
// (vertex, from) to its far end. Returns the last triangle; `end` is the vertex of its free edge, or `from`
// again where the fan closes.
Index walk_fan(const Complex& complex, const Kept& kept, Index vertex, Index t, Index from, Index& end);

// The loops of the kept triangles' rim, each simple: a rim that meets itself in a pinch is split there.
// Each is directed as the triangle at its first edge is oriented (surface on the left).
std::vector<std::vector<Index>> walk_rims(const Complex& complex, const Kept& kept, const Run& run = {});

}  // namespace rimline::exact
