// SPDX-License-Identifier: GPL-3.0-or-later
// A loop redrawn along a smooth curve, where noise or random sampling makes its points uncertain.
#pragma once

#include <vector>

#include "local/noise.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct SmoothedLoop {
  std::vector<Index> loop;  // simple; empty where the rim can not be redrawn
  std::vector<Index> near;  // all points that were looked at, from the outermost inwards ...
  std::vector<double>
      depth;  // ... and the distance of each outside the separating line, in spacings: the line
};

// Under noise the points at which a triangulation ends are random. So a curve is fitted along the rim by
// moving least squares over some spacings, and the points are ranked by their distance outwards. The
// outermost points are the loop, as many as a rim has at the density behind it. Where points are even, the
// loop is the most probable path: through points that lie far out, in nearly equal steps; otherwise it visits
// the outermost points in the order of the curve.
//
// A rim has one point per spacing (the root of the area of a point). Among random points, those within half a
// spacing of the rim can not be told from rim points. The loop does not visit them, because it would be a
// tenth too long and jagged.
//
// `rim`: a loop with the surface on its left; `normals`: unit normals of the surface at its points, oriented
// alike. The rim must be longer than about ten spacings.
SmoothedLoop smooth_loop(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         const std::vector<Index>& rim, const std::vector<Point>& normals,
                         const NoiseModel& noise, const Run& run = {});

}  // namespace rimline
