// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that may be the surface.
#pragma once

#include <vector>

#include "local/star.h"
#include "rimline/run.h"
#include "surface/triangle_set.h"

namespace rimline {

// Puts the stars together. A triangle that is in the stars of all its corners is taken: these alone are a
// surface with boundary, since all triangles at an edge are then in one planar star. The others are offered
// in order of votes and size, and taken where they fit; then ears in the rim are filled, the smallest
// first. Triangles whose circumradius exceeds `largest` spacings (the largest of their corners') are left
// out, so the result reaches over the true boundary by its larger triangles: what is too much is for the rim
// search to take away.
TriangleSet propose_surface(Points points, const std::vector<Frame>& frames, const DelaunayStars& stars,
                            const std::vector<double>& spacing, double largest, const Run& run);

// Fills ears in the rim with triangles up to `largest`, the smallest first.
void fill_missing_ears(TriangleSet& set, const std::vector<double>& spacing, double largest, const Run& run);

}  // namespace rimline
