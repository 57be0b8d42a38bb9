// SPDX-License-Identifier: GPL-3.0-or-later
// The k-nearest graph: found once, used by every stage.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"

namespace rimline {

// The k nearest points of every point, the point itself left out (section 2.3: the k Euclidean nearest
// sample points stand for the k-neighbourhood, by Assumption 2.5). Each list ascends by distance; points at
// equal distance ascend by coordinates (x, then y, then z), then by id, so that the lists do not depend on
// the order of the points where all points are distinct.
struct Neighbours {
  int k = 0;                  // neighbours per point: what was asked for, or n - 1 where the set is smaller
  UnfilledVector<Index> ids;  // n * k, list after list

  Index size() const { return k == 0 ? 0 : static_cast<Index>(ids.size() / static_cast<std::size_t>(k)); }
  std::span<const Index> of(Index point) const { return of(point, k); }
  // The nearest `count` of them, count <= k.
  std::span<const Index> of(Index point, int count) const {
    return {ids.data() + static_cast<std::size_t>(point) * k, static_cast<std::size_t>(count)};
  }
};

// The distance from a point to the neighbour at `rank`, 0 for the nearest. It is computed again from the
// points: that is faster than reading lists of distances from memory.  [ours]
inline double distance_to(Points points, const Neighbours& neighbours, Index point, int rank) {
  return distance(points[point], points[neighbours.of(point)[static_cast<std::size_t>(rank)]]);
}

// Requires finite points and k >= 1. Throws TooFewPoints for fewer than two points.
Neighbours find_neighbours(Points points, int k, const Run& run);

// The spacing of every point: the mean distance to its six nearest neighbours (fewer in a smaller set).
std::vector<double> local_spacing(Points points, const Neighbours& neighbours, const Run& run = {});

}  // namespace rimline
