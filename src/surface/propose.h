// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that may be the surface.
#pragma once

#include <vector>

#include "local/samples.h"
#include "local/star.h"
#include "rimline/run.h"
#include "surface/triangle_set.h"

namespace rimline {

// Assembles the stars. Triangles in the stars of all their corners are taken: these alone are a surface with
// boundary, since all triangles at an edge are in one planar star. The others are taken in order of votes and
// size where they fit; then missing ears of the rim are filled, the smallest first. Triangles whose
// circumradius exceeds `largest` spacings (the largest of their corners') are left out. The result extends
// over the true boundary by its larger triangles, which the search removes.
TriangleSet propose_surface(Points points, const std::vector<Frame>& frames, const Stars& stars,
                            const std::vector<double>& spacing, double largest, const Run& run);

// The same for samples, with the stars and the largest size of the default method.
TriangleSet propose_surface(const Samples& samples, const Run& run);

// The set with the missing ears of its rims: triangles up to `largest` between two rim edges in a row, the
// smallest first.
TriangleSet with_missing_ears(TriangleSet set, const std::vector<double>& spacing, double largest,
                              const Run& run);

}  // namespace rimline
