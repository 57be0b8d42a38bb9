// SPDX-License-Identifier: GPL-3.0-or-later
// Removes the self-crossings of a loop.
#pragma once

#include <vector>

#include "loops/smooth_curve/rim_curve.h"

namespace rimline {

// Reverses sections of up to eight edges wherever that shortens the loop in projection along the normals: it
// then does not cross itself there. The 2-opt moves of Croes (1958), restricted to near edges. Loops of fewer
// than 24 points are returned as they are.
std::vector<RimSample> untangle(Points points, std::vector<RimSample> loop);

}  // namespace rimline
