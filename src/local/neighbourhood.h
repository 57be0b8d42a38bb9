// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete neighbourhood of a point, projected to the plane: sections 2.2 and 2.3.
#pragma once

#include <span>
#include <vector>

#include "base/lanes.h"
#include "local/principal_axes.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// Assumption 2.4's share of the second principal direction; 0 where all neighbours coincide.
double delta(const PrincipalAxes& axes);

// The neighbours of several points at a time, one point in each lane, one array for each coordinate. All
// arrays are padded with zeros to an even length: an offset of zero adds nothing to any sum.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(int k) : k_(k), x_(k + k % 2), y_(x_), z_(x_), u_(x_), v_(x_) {}

  // Takes the offsets of the k nearest neighbours of the points from `first` on: as many points as there are
  // lanes, or up to `end`. The content of unused lanes does not matter.
  void gather(Points points, const Neighbours& neighbours, Index first, Index end);

  // The sums of squares about the centroid of `count` points: of the k neighbours, or of k + 1, them and the
  // point itself.
  void sum_squares(int count, CovarianceLanes& m) const;

  // The principal axes of the covariance of the k neighbours (the point itself left out), section 2.2.
  // Eigenvalues are of the sums of squares, in the squared unit of the points, and ascend as in the paper:
  // the first belongs to the normal of the least squares plane T.
  void find_axes(PrincipalAxesLanes& axes) const;

  // How far the points are from the least squares plane of their neighbours, at least 0.
  void find_heights(const PrincipalAxesLanes& axes, Lanes& height) const;

  // The image of the neighbours under h = sigma after pi, about the image of the point: pi projects on T and
  // sigma gives v3 and v2 equal variability. First coordinate along v3, second along v2. Each direction
  // points to where the third moment of the offsets is positive, so that turning or mirroring the input
  // changes nothing; the paper leaves this open [ours, docs/departures.md].
  void flatten(const PrincipalAxesLanes& axes);

  // Of the image, k each.
  std::span<const Lanes> u() const { return {u_.data(), static_cast<std::size_t>(k_)}; }
  std::span<const Lanes> v() const { return {v_.data(), static_cast<std::size_t>(k_)}; }

 private:
  int k_;
  std::vector<Lanes> x_, y_, z_;  // offsets from the point
  std::vector<Lanes> u_, v_;      // the image
};

}  // namespace rimline
