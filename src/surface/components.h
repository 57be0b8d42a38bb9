// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components of a set of triangles, and the side that each shows.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/components.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// find_components() of the selected triangles. Each component's mean normal gets a positive z (or y, or x
// where those before vanish).
Components find_components(const TriangleSet& set, const Selection& selected, const Run& run = {});

// The set with the marked triangles turned over.
TriangleSet turn_over(TriangleSet set, const std::vector<std::uint8_t>& marked, const Run& run = {});

}  // namespace rimline
