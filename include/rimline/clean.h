// SPDX-License-Identifier: GPL-3.0-or-later
// What a scanner adds to a surface: points that are none of it.  [ours: the paper assumes a clean sample]
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Points that are no part of the surface, by what tells; a list each, ascending, no point in two.
struct StrayPoints {
  std::vector<Index> off_surface;  // single ones beside a surface that goes on without them
  std::vector<Index> on_line;      // in a line that leads away from it
  std::vector<Index> apart;        // in a small group with a wide gap around it

  bool empty() const { return off_surface.empty() && on_line.empty() && apart.empty(); }
};

// All of them, ascending.
std::vector<Index> all_of(const StrayPoints& stray);

// Finds them by the neighbourhoods alone: docs/stages/clean.md. Where there are many, some are told only
// after others are gone, so that what is left, with new neighbours, is to be asked again. Requires finite and
// distinct points and lists of at least 24 neighbours, or of all where there are fewer. `spacing`:
// local_spacing().
StrayPoints find_stray_points(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                              const Run& run);

}  // namespace rimline
