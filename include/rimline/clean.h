// SPDX-License-Identifier: GPL-3.0-or-later
// Stray points: points of a scan that are not on the surface.  [ours: the paper assumes a clean sample]
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Points that are not part of the surface, a list for each reason. Lists ascend; no point is in two.
struct StrayPoints {
  std::vector<Index> off_surface;  // single points beside a surface that is complete without them
  std::vector<Index> on_line;      // in a line of points that leads away from the surface
  std::vector<Index> apart;        // in a small group with a wide gap around it

  bool empty() const { return off_surface.empty() && on_line.empty() && apart.empty(); }
};

// All of them, ascending.
std::vector<Index> all_of(const StrayPoints& stray);

// Finds stray points from their neighbourhoods (docs/stages/clean.md). Where there are many, some are found
// only after others were removed: remove these, find the neighbours again, and repeat. Requires finite and
// distinct points and lists of at least 24 neighbours, or of all where there are fewer. `spacing`:
// local_spacing().
StrayPoints find_stray_points(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                              const Run& run);

}  // namespace rimline
