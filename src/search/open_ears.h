// SPDX-License-Identifier: GPL-3.0-or-later
// Ears that one selection opens and another does not.
#pragma once

#include <cstddef>

#include "rimline/run.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// The selection `before`, without the ears that `after` leaves out. An ear is a run of at most `most`
// triangles that hang together over shared vertices, all of them left out by `after` and none by `before`,
// whose going changes neither the number of rims nor of points where rims meet. Ours: where a long run goes,
// a whole row of the rim may be gone, for which no triangle of it speaks; what would join two rims is left to
// the search for openings.
Selection open_ears(const TriangleSet& set, const Selection& before, const Selection& after, std::size_t most,
                    const Run& run);

}  // namespace rimline
