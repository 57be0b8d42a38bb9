// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a manifold of any topology from the triangles that the loops were found on.
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
  std::vector<Triangle> triangles;  // consistently oriented where that is possible
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

// Each edge gets at most two triangles, each vertex one fan. Rims without a loop are gaps and are closed
// where that repeats no edge; a component without a loop is closed completely where little is missing, and
// otherwise ends at its rims. Points above a triangle are inserted. Components of few triangles are dropped
// beside larger ones.
std::vector<MendedPart> mend_surface(const MendInput& input, HandlePolicy handles, const Run& run);

}  // namespace rimline
