// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth of jagged rims.
#pragma once

#include <vector>

#include "evidence/corner_histogram.h"
#include "surface/local_size.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// Leaves out the triangles that close ears of jagged rims, one layer deep: those at an edge of a rim whose
// third corner is more likely on the boundary than not, most likely first. The search, which weighs the
// size of triangles and what the rim turns, keeps them, since on an even rim nearly all of them belong to the
// surface. Returns the third corners.
std::vector<Index> remove_false_ears(const TriangleSet& set, LocalSizes& sizes, const CornerHistogram& usual,
                                     const std::vector<std::vector<Index>>& rims, Selection& selected);

}  // namespace rimline
