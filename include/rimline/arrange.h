// SPDX-License-Identifier: GPL-3.0-or-later
// The door: what the stages are given is finite, distinct, near the origin and in an order that memory likes.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The points that take part, along a Morton curve. The order depends on the coordinates alone, so permuting
// the input changes nothing after this stage but the ids it is translated back to.
struct Arrangement {
  std::vector<Point> points;      // finite, distinct; the input's less `origin`
  std::vector<Index> ids;         // points[i] is the input's point ids[i]
  Point origin;                   // the centre of the bounding box of the points that take part
  std::vector<Index> not_finite;  // input ids, ascending
  std::vector<Index> duplicates;  // input ids, ascending; the lowest id of each place is kept
  std::vector<Index> stray;       // input ids, ascending; far ones, and those left out by the functions below
};

// Points out of all proportion, a million times as far away as most are from each other, are stray at once:
// next to them, all others would be one place. Throws TooFewPoints where no finite point is left.
Arrangement arrange(Points input, const Run& run);

// Takes points, given by their places in the arrangement, ascending, out of it and adds their ids to `stray`.
void leave_out(Arrangement& arrangement, const std::vector<Index>& places);

// Finds the groups of the mutual k-nearest graph (each of two points in the other's list) that have fewer
// than `least_group` points, and takes them out of the arrangement. Returns whether there were any: the
// neighbours must then be found again.  [ours: the paper assumes a clean sample]
bool leave_out_stray(Arrangement& arrangement, const Neighbours& neighbours, const Run& run = {},
                     int least_group = 10);

}  // namespace rimline
