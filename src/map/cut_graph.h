// SPDX-License-Identifier: GPL-3.0-or-later
// Short cuts that leave a surface no handle.
#pragma once

#include "map/open_mesh.h"

namespace rimline {

// Cuts that leave the surface in one part without handles. Its loops are taken for caps, so that they need
// not be joined. Of the systems of closed curves through one vertex it is the shortest (Erickson & Whittlesey
// 2005, by tree and cotree), pruned to what they are without it; the vertex lies on the shortest curve of a
// first system. Nothing is cut where there is no handle. Time n log n in the triangles.
Cuts cut_handles(const OpenMesh& open);

// A cut from a vertex to a loop, or where there is none to the vertex that is farthest from it. At least two
// edges long inside of a surface. Nothing where there is no such path.
Cuts slit(const OpenMesh& open, Index vertex, const std::vector<Index>& to);

}  // namespace rimline
