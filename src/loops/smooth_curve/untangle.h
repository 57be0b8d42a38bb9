// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the crossings out of a loop.
#pragma once

#include <vector>

#include "loops/smooth_curve/rim_curve.h"

namespace rimline {

// The loop with stretches of up to eight edges turned round wherever that makes it shorter, as seen along the
// normals: it then does not cross itself there. The 2-opt moves of Croes (1958), among near edges alone.
// Loops of fewer than 24 points are left as they are.
std::vector<RimSample> untangle(Points points, std::vector<RimSample> loop);

}  // namespace rimline
