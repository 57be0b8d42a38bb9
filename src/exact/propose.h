// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that may be the surface.
#pragma once

#include <vector>

#include "exact/complex.h"
#include "exact/star.h"
#include "rimline/run.h"

namespace rimline::exact {

// Puts the stars together. A triangle that is in the stars of all its corners is taken: these alone are a
// surface with boundary, since all triangles at an edge are then in one planar star. The others are offered
// in order of votes and size, and taken where they fit; then notches in the rim are filled, the smallest
// first. Triangles whose circumradius exceeds `largest` spacings (the largest of their corners') are left
// out, so the result reaches over the true boundary by its larger triangles: what is too much is for the rim
// search to take away.
Complex propose_surface(Points points, const std::vector<Frame>& frames, const Stars& stars,
                        const std::vector<double>& spacing, double largest, const Run& run);

// Fills notches in the rim with triangles up to `largest`, the smallest first.
void fill_notches(Complex& complex, const std::vector<double>& spacing, double largest, const Run& run);

}  // namespace rimline::exact
