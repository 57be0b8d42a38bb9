// SPDX-License-Identifier: GPL-3.0-or-later
// What local evidence alone says of the boundary, before anything is joined.
#pragma once

#include <vector>

#include "local/star.h"
#include "quality/edge_set.h"
#include "quality/loop_score.h"

namespace rimline::bench {

// The triangles of a point's star up to 1.7 spacings in circumradius form a fan; where exactly one opening is
// left, the two edges at it are where the boundary enters and leaves the point. Returned are the edges that
// both of their ends name.
EdgeSet mutual_edges(Points points, const Stars& stars, const std::vector<double>& spacing);

// The connected pieces of the edges that are closed loops: each point has two edges. The others are lost.
LoopIds closed_arcs(const EdgeSet& edges);

}  // namespace rimline::bench
