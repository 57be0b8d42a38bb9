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
  // The band of the set: the loop is no sum of triangles of it (going_round() in paper/band.h), and two
  // thirds of the points of the set are on it or joined to it.
  bool goes_round = false;
};

// Some of the points `ids` (ascending) in order.
//
// The winner is a band two or three points wide. Its points are joined to their neighbours. The cheapest ways
// from the highest score, plus one join that is on none of them, are a simple cycle. Of those that are no sum
// of triangles (where there are none, of all) and that are at least half as long as the longest of them, the
// cheapest is the loop.
OrderedLoop order_loop(Points points, const Neighbours& neighbours, int path_k, const BoundaryScores& scores,
                       std::span<const Index> ids);

}  // namespace rimline
