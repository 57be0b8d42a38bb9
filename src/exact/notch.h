// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth of jagged rims.
#pragma once

#include <vector>

#include "exact/complex.h"
#include "exact/local_size.h"
#include "exact/rim.h"
#include "exact/usual_corners.h"

namespace rimline::exact {

// Leaves out the triangles that close notches of jagged rims, one layer deep: those at an edge of a rim whose
// third corner is more likely on the boundary than not, most likely first. The search, which weighs the
// size of triangles and what the rim turns, keeps them, since on an even rim nearly all of them belong to the
// surface. Returns the third corners.
std::vector<Index> open_notches(const Complex& complex, LocalSizes& sizes, const UsualCorners& usual,
                                const std::vector<std::vector<Index>>& rims, Kept& kept);

}  // namespace rimline::exact
