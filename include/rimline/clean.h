// SPDX-License-Identifier: GPL-3.0-or-later
// Stray points: points of a scan that are not on the surface. Coordinates in steps.  [ours: the paper assumes
// a clean sample]
#pragma once

#include <optional>
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

// The values of a coordinate that is rounded, or of a regular grid.
struct Levels {
  std::vector<double> at;     // ascending, in the unit of the points
  std::vector<double> index;  // of each level: how many steps it lies above the first; missing levels count
  double quantum = 0;         // the median step, in the unit of the points
};

// The levels of a coordinate of the points; none where it is not in steps. `spacing`: of the points; steps of
// less than a twentieth of it are no steps.
std::optional<Levels> find_levels(Points points, double Point::*axis, double spacing);

// Terraces: steps so high that they part a surface. They lie along an axis, or along the rays of a camera.
struct Terraces {
  std::optional<Point> centre;  // of the rays; none along an axis
  int axis = 2;                 // 0, 1, 2, where there is no centre
  Levels levels;
};

// Looks along the three axes and along the rays from each place of `centres`. Points are on terraces where
// most of them have most of their neighbours on their own level, and a step is longer than 1.2 spacings. The
// places are in the coordinates of the points. `spacing`: local_spacing().
std::optional<Terraces> find_terraces(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing, const std::vector<Point>& centres,
                                      const Run& run);

// The points moved along that direction, by a step at most, onto a surface without terraces. Where the
// surface runs along the direction they stay; where most do there are no terraces but rows, and the result is
// empty. `spacing`: local_spacing().
std::vector<Point> without_terraces(Points points, const Terraces& terraces,
                                    const std::vector<double>& spacing, const Run& run);

}  // namespace rimline
