// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares the input of the stages: finite, distinct points near the origin, in Morton order.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The points in use, along a Morton curve. The order depends on the coordinates alone, so permuting the input
// changes nothing after this stage but the ids that results are translated back to.
struct Arrangement {
  std::vector<Point> points;      // finite, distinct; the input's less `origin`
  std::vector<Index> ids;         // points[i] is the input's point ids[i]
  Point origin;                   // the centre of the bounding box of the points in use
  std::vector<Index> not_finite;  // input ids, ascending
  std::vector<Index> duplicates;  // input ids, ascending; the lowest id of each place is kept
  std::vector<Index> stray;       // input ids, ascending; far ones, and those left out by the functions below
};

// A point that is a million times as far away as most points are from each other is stray: at its scale all
// others would coincide. Throws TooFewPoints where no finite point is left.
Arrangement arrange(Points input, const Run& run);

// Removes points, given as ascending positions in the arrangement, and adds their ids to `stray`.
void leave_out(Arrangement& arrangement, const std::vector<Index>& places);

// Finds the groups of the mutual k-nearest graph (each of two points in the other's list) that have fewer
// than `least_group` points, and takes them out of the arrangement. Returns whether there were any: the
// neighbours must then be found again.  [ours: the paper assumes a clean sample]
bool leave_out_stray(Arrangement& arrangement, const Neighbours& neighbours, const Run& run = {},
                     int least_group = 10);

}  // namespace rimline
