// SPDX-License-Identifier: GPL-3.0-or-later
// Short cuts that remove all handles of a surface.
#pragma once

#include "map/open_mesh.h"

namespace rimline {

// Cuts that leave the surface connected and without handles. Its loops are taken to be capped, so that they
// need not be joined. The shortest system of closed curves through one vertex (Erickson & Whittlesey 2005, by
// tree and cotree), without their common paths; the vertex lies on the shortest curve of a first system. No
// cuts without handles. Time n log n in the triangles.
Cuts cut_handles(const OpenMesh& open);

// A cut from a vertex to a loop, or without loops to the farthest vertex. At least two edges long in the
// interior. None where there is no such path.
Cuts slit(const OpenMesh& open, Index vertex, const std::vector<Index>& to);

}  // namespace rimline
