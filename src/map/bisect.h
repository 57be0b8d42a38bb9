// SPDX-License-Identifier: GPL-3.0-or-later
// A chart made two.
#pragma once

#include <vector>

#include "map/open_mesh.h"

namespace rimline {

// Per triangle 0 on the side of `vertex`, 1 on that of the vertex farthest from it. Between them the cut runs
// along a level of the share of the way from one to the other: where it is short against the root of the
// lesser area, a tenth of the whole at least, then straightened. Triangles of one label may hang together in
// several parts.
std::vector<Index> bisect(const OpenMesh& open, Index vertex);

}  // namespace rimline
