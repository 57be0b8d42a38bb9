// SPDX-License-Identifier: GPL-3.0-or-later
// How large a triangle is against those around it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/model.h"
#include "base/prefault.h"
#include "rimline/neighbours.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"
#include "surface/star_levels.h"
#include "surface/triangle_set.h"

namespace rimline {

// The circumradii of the triangles around a point: at it and at its 16 nearest neighbours.
struct LocalSize {
  double typical = -1;  // the value 5/8 up: between median and upper quartile
  double spread = 0;    // interquartile range over it: about 0 on a grid, 0.3 on scans, 0.5 at random
};

// Spacing alone does not say which triangle is too large: a rim triangle of one spacing closes a true ear
// on an even sample and is nothing unusual on a random one. Values are computed when first asked for, or for
// many vertices at once by find(): they are the same, so all answers depend on the triangles and the lists
// alone. What was found may be asked for by many threads; the rest by one at a time.
class LocalSizes {
 public:
  LocalSizes(const TriangleSet& set, const Neighbours& neighbours, const Run& run = {})
      : set_(set), neighbours_(neighbours) {
    resize_together(known_, set.vertices(), run);
  }

  const LocalSize& at(Index vertex) const;
  bool is_known(Index vertex) const { return known_[vertex].typical >= 0; }
  // Computes those of the given ones.
  void find(std::span<const Index> vertices, const Run& run) const;
  // Bounds from below what radii have to be for a log_ratio of more than the margin, not negative, plus the
  // spread, at all vertices: that costs a fraction of the sizes. Does nothing where these limits are known.
  void find_limits(double margin, const Run& run) const;
  // Whether the log_ratio of a triangle may be that much, as far as the limits at its corners tell. Never
  // false where it is.
  bool may_exceed(Index triangle) const;
  // Computes anew, or forgets until asked for, all that the triangles at the marked vertices have a part in:
  // after these have changed.
  void forget(const std::vector<std::uint8_t>& changed, const Run& run);
  // Median circumradius of the triangles at the vertex alone.
  double own(Index vertex) const;
  // Logarithm of a triangle's circumradius over the typical one around its corners, at most 3.
  double log_ratio(const Triangle& triangle) const;
  double spread(const Triangle& triangle) const;

 private:
  static constexpr int around = model::more_neighbours;  // nearest, whose triangles count

  LocalSize measure(Index vertex, std::vector<double>& radii) const;
  void bound(Index begin, Index end) const;

  const TriangleSet& set_;
  const Neighbours& neighbours_;
  // What was asked for before: a memo, which changes no answer.
  mutable std::vector<LocalSize> known_;
  mutable std::optional<StarLevels> levels_;
  mutable double margin_ = 0;
  mutable UnfilledVector<float> inverse_limit_;
  mutable std::vector<double> radii_;
};

}  // namespace rimline
