// SPDX-License-Identifier: GPL-3.0-or-later
// A manifold of any topology, made of the triangles that the loops were found on.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// One component of the surface.
struct MendedPart {
  std::vector<Triangle> triangles;  // oriented alike where it can be
  std::vector<Loop> loops;          // its rims, the outer one first; none where it is closed
  bool orientable = true;
  int genus = 0;  // handles; of a one-sided surface the number of cross-caps
  std::vector<HandleRepair> repairs;
};

struct MendInput {
  Points points;
  const Neighbours& neighbours;
  std::span<const double> spacing;  // one per point
  std::span<const Triangle> triangles;
  const std::vector<Loop>& loops;
};

// Each edge gets at most two triangles, each vertex one fan. Rims that no loop runs along are gaps and are
// closed where that makes no edge twice; a part without a loop is closed all round where little is missing,
// and ends at its rims elsewhere. Points that lie over a triangle are put into it. Scraps of few triangles
// are left out beside larger parts.
std::vector<MendedPart> mend_surface(const MendInput& input, HandlePolicy handles, const Run& run);

}  // namespace rimline
