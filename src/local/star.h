// SPDX-License-Identifier: GPL-3.0-or-later
// The local Delaunay star of a point: the neighbours that surround it, in order.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"

namespace rimline {

// The neighbours around a point, counter-clockwise in its frame. Each two in a row (and the last with the
// first) make a triangle with the point. `none` marks an open side of the point's Voronoi cell.
using Star = std::span<const Index>;

// One star per point, concatenated in one array.
class Stars {
 public:
  Stars() = default;
  // Star i is ids[start[i]] to ids[start[i + 1] - 1]; weights likewise, or empty.
  Stars(std::vector<std::size_t> start, UnfilledVector<Index> ids, UnfilledVector<double> weights = {})
      : start_(std::move(start)), ids_(std::move(ids)), weights_(std::move(weights)) {}

  std::size_t size() const { return start_.size() - 1; }
  Star operator[](std::size_t i) const { return {ids_.data() + start_[i], start_[i + 1] - start_[i]}; }
  std::size_t start(std::size_t i) const { return start_[i]; }
  // Of each neighbour, in the same order.
  std::span<const double> weights(std::size_t i) const {
    return {weights_.data() + start_[i], start_[i + 1] - start_[i]};
  }

 private:
  std::vector<std::size_t> start_{0};
  UnfilledVector<Index> ids_;
  UnfilledVector<double> weights_;
};

// Finds the stars. The neighbours of a point, and the points that have it as a neighbour, are projected to
// its tangent plane at their true distance. The Voronoi cell is cut by their bisectors, nearest first; the
// bisectors that bound the cell give the star. Takes about one microsecond a point; no global Delaunay
// triangulation is built. The stars have no weights.
//
// Both directions are needed at density borders: a point on the dense side does not have the points of the
// sparse side among its nearest, but they have it.
Stars find_stars(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                 const std::vector<Frame>& frames, const Run& run);

// Finds stars from the point's own list alone, with cells that reach no farther than the list, and with
// weights of natural neighbours: the length of the common side of two cells over the distance of their
// points. Weights are positive, and exact for linear functions where the cell is closed and flat (Sibson
// 1981; Belikov et al. 1997). [ours: the paper's reciprocal distances to k neighbours reach across walls and
// holes]
Stars find_weighted_stars(Points points, const Neighbours& neighbours, const Run& run);

}  // namespace rimline
