// SPDX-License-Identifier: GPL-3.0-or-later
// From the winning set of points to an ordered loop. The paper needs the order (section 5 maps the boundary
// "in some predefined order") and does not say where it comes from: all of this is ours, docs/departures.md.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/score_boundary.h"

namespace rimline {

struct OrderedLoop {
  std::vector<Index> points;  // a simple closed polyline; empty where the set has no cycle
  // Whether the loop is essential in the band of the set (going_round() in paper/band.h), and two thirds of
  // the points of the set are on it or joined to it.
  bool goes_round = false;
};

// Orders some of the points `ids` (ascending) as a loop.
//
// The winner is a band two or three points wide. Its points are joined to their neighbours. The cheapest
// paths from the point of highest score, plus one join, form simple cycles. Among the essential ones (among
// all where there are none) that are at least half as long as the longest, the cheapest is the loop.
OrderedLoop order_loop(Points points, const Neighbours& neighbours, int path_k, const BoundaryScores& scores,
                       std::span<const Index> ids);

}  // namespace rimline
