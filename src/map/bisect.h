// SPDX-License-Identifier: GPL-3.0-or-later
// Bisects a chart.
#pragma once

#include <vector>

#include "map/open_mesh.h"

namespace rimline {

// Returns per triangle 0 on the side of `vertex`, 1 on the side of the vertex farthest from it. The cut is a
// level line of the share of the way between them, where it is short relative to the root of the smaller area
// (at least a tenth of the whole), then straightened. Triangles of one label may be in several connected
// parts.
std::vector<Index> bisect(const OpenMesh& open, Index vertex);

// The parts that it leaves.
std::vector<OpenMesh> halves(const OpenMesh& open, Index vertex);

}  // namespace rimline
