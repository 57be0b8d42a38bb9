// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a triangle relative to the triangles around it.
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
  double typical = -1;  // the 5/8 quantile, between median and upper quartile
  double spread = 0;    // interquartile range over it: about 0 on a grid, 0.3 on scans, 0.5 at random
};

// Spacing alone does not tell which triangle is too large: a rim triangle of one spacing closes a true ear on
// an even sample and is usual on a random one. Values are computed on demand, or for many vertices at once by
// find(), with the same results: all answers depend on the triangles and the lists alone. Values already
// computed may be read by many threads; everything else by one at a time.
class LocalSizes {
 public:
  LocalSizes(const TriangleSet& set, const Neighbours& neighbours, const Run& run = {})
      : set_(set), neighbours_(neighbours) {
    resize_together(known_, set.vertices(), run);
  }

  const LocalSize& at(Index vertex) const;
  bool is_known(Index vertex) const { return known_[vertex].typical >= 0; }
  // Computes the sizes of the given vertices.
  void find(std::span<const Index> vertices, const Run& run) const;
  // Computes lower bounds of the radii that have a log_ratio above the margin (not negative) plus the spread,
  // at all vertices, for a fraction of the cost of the sizes. Does nothing where these limits are known.
  void find_limits(double margin, const Run& run) const;
  // Whether the log_ratio of a triangle may be that large, by the limits at its corners. Never a false
  // negative.
  bool may_exceed(Index triangle) const;
  // Recomputes, or discards, everything that depends on the triangles at the marked vertices, after these
  // have changed.
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
  // A cache: it changes no answer.
  mutable std::vector<LocalSize> known_;
  mutable std::optional<StarLevels> levels_;
  mutable double margin_ = 0;
  mutable UnfilledVector<float> inverse_limit_;
  mutable std::vector<double> radii_;
};

}  // namespace rimline
