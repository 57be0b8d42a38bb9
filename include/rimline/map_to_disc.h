// SPDX-License-Identifier: GPL-3.0-or-later
// From the loop to the plane: section 5 of the paper.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/report.h"

namespace rimline {

// The positions of the loop's points on the unit circle: counter-clockwise in their order, the first at angle
// 0, each arc in proportion to its chord, the distance of its two points.
std::vector<UV> circle_by_chord_length(Points points, std::span<const Index> loop);

struct DiscMap {
  std::vector<UV> uv;  // one per point, all in the closed unit disc
  MapSummary summary;
};

// Eq. (4): every point that is not on the loop becomes the convex combination of its options.map_k nearest
// neighbours with reciprocal distance weights. Solved to options.residual.
// Throws UnreachableInterior with the ids of the points without a chain of neighbours to the loop (the
// system is singular there), and NoConvergence where the residual can not be reached.
DiscMap map_to_disc(Points points, const Neighbours& neighbours, std::span<const Index> loop,
                    const ParameterizeOptions& options, const Run& run);

}  // namespace rimline
