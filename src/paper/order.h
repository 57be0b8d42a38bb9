// SPDX-License-Identifier: GPL-3.0-or-later
// From the winning set of points to an ordered loop. The paper needs the order (section 5 maps the boundary
// "in some predefined order") and does not say where it comes from: all of this is ours, docs/departures.md.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/score_boundary.h"

namespace rimline {

// A simple closed polyline through some of the points `ids` (ascending), or empty where there is none.
//
// The winner is a band two or three points wide. Its points are joined to their neighbours, and a join costs
// its squared length over the sum of both scores: many short steps along high scores beat few long ones. A
// tree of cheapest paths from the highest score, plus one join that is not in the tree, is a simple cycle.
// Of the cycles at least half as long as the longest, which go around the band rather than across it, the
// cheapest is the loop.
std::vector<Index> order_loop(Points points, const Neighbours& neighbours, int path_k,
                              const BoundaryScores& scores, std::span<const Index> ids);

}  // namespace rimline
