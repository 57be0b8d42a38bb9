// SPDX-License-Identifier: GPL-3.0-or-later
// Orientation of surfaces that enclose a volume.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

enum class Side { Unknown, Outward, Inward };

// Tells which way the triangles of a surface face, if the surface with its loops capped encloses most of a
// volume: the caps have at most 0.4 of its area, and the volume is at least 0.1 of that of a ball of the same
// area, as on heads, limbs and closed bodies. Unknown for any other surface.
Side faced_side(Points points, std::span<const Triangle> triangles, const std::vector<Loop>& loops);

}  // namespace rimline
