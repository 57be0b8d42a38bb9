// SPDX-License-Identifier: GPL-3.0-or-later
// The convex outlines that a patch can be mapped to.
#pragma once

#include <span>
#include <vector>

#include "rimline/refine_surface.h"

namespace rimline {

// Places the outer loop, counter-clockwise, on the outline of a convex domain: the unit circle, the unit
// square, or a rectangle of width 1 whose height follows from the lengths of the loop's sides. Along each
// part by chord length. Sides of square and rectangle bulge by a thousandth of their length, so that no
// triangle with all its corners on one side is flat.
void place_outline(Points points, const std::vector<Index>& loop, Domain domain,
                   std::span<const Index, 4> corners, std::vector<UV>& uv);

// Four corners of a loop, as positions in it, ascending: where it turns most at the scale of a twentieth of
// its length, at least a tenth of its length apart.
std::array<std::size_t, 4> find_corners(Points points, const std::vector<Index>& loop);

}  // namespace rimline
