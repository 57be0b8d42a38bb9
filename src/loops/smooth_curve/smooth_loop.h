// SPDX-License-Identifier: GPL-3.0-or-later
// A loop drawn anew over a smooth curve along its rim, where noise or chance blurs which points are on it.
#pragma once

#include <vector>

#include "local/noise.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct SmoothedLoop {
  std::vector<Index> loop;    // simple; empty where the rim can not be drawn anew
  std::vector<Index> near;    // all points that were looked at, from the outermost inwards ...
  std::vector<double> depth;  // ... and how far outside the parting line each lies, in spacings: the line
                              // between the points that may be on the boundary and those inside it
};

// Under noise it is chance at which of the points about a rim a triangulation ends. So a curve is fitted
// along the rim by moving least squares, over some spacings, and points are ranked by how far out of it they
// lie. The outermost may be the loop, as many as a rim has at the density behind it. Where points are even,
// the loop is the likeliest path: through points that lie far out, in steps that are about equal; else it is
// the outermost. The curve puts them in order.
//
// A rim has one point to a spacing (the root of the area of a point). Among random points, those within half
// a spacing of the rim may be on it as well: nothing tells them from it. The loop does not go through them,
// as it would be a tenth too long and jagged.
//
// `rim`: a loop with the surface on its left; `normals`: unit normals of the surface at its points, oriented
// alike. The rim must be longer than about ten spacings.
SmoothedLoop smooth_loop(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         const std::vector<Index>& rim, const std::vector<Point>& normals,
                         const NoiseModel& noise, const Run& run = {});

}  // namespace rimline
