// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the holes of a patch that its policy closes.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangulation.h"
#include "rimline/refine_surface.h"

namespace rimline {

// Whether the policy closes a hole with this rim.
bool is_filled(Points points, const Loop& rim, const HolePolicy& policy);

struct HoleFills {
  std::vector<Triangle> triangles;  // of all fills, one after the other
  std::vector<Point> added;         // their ids follow those of `points`
  std::vector<HoleFill> fills;
  std::vector<Loop> loops;  // the loops that stay, the outer one first
};

// Closes holes of the mesh. `loops`: its boundary, the outer loop first. The mesh stays as it is: a fill
// makes no edge that the mesh has. `spacing` is one per point.
HoleFills fill_holes(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                     std::span<const double> spacing, const RefineOptions& options, const Run& run);

}  // namespace rimline
