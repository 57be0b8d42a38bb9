// SPDX-License-Identifier: GPL-3.0-or-later
// How large a triangle is against those around it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "exact/complex.h"
#include "rimline/neighbours.h"
#include "rimline/run.h"

namespace rimline::exact {

// The circumradii of the triangles around a point: at it and at its 16 nearest neighbours.
struct LocalSize {
  double typical = -1;  // the value 5/8 up: between median and upper quartile
  double spread = 0;    // interquartile range over it: about 0 on a grid, 0.3 on scans, 0.5 at random
};

// Spacing alone does not say which triangle is too large: a rim triangle of one spacing closes a true notch
// on an even sample and is nothing unusual on a random one. Values are computed when first asked for, or for
// many vertices at once by find(); they are the same. What was found may be asked for by many threads.
class LocalSizes {
 public:
  LocalSizes(const Complex& complex, const Neighbours& neighbours)
      : complex_(complex), neighbours_(neighbours), known_(complex.vertices()) {}

  const LocalSize& at(Index vertex);
  // Computes those of the vertices v for which wanted(v), and forgets none.
  void find(const std::function<bool(Index)>& wanted, const Run& run);
  // The same for the given ones.
  void find(std::span<const Index> vertices, const Run& run);
  // Brackets them, which costs a fraction, for may_exceed().
  void find_bounds(const std::function<bool(Index)>& wanted, const Run& run);
  // Whether the log_ratio of a triangle may be more than the margin, not negative, plus its spread, as far
  // as the bounds at its corners tell. Never false where it is.
  bool may_exceed(Index triangle, double margin) const;
  // Forgets all that the triangles at the marked vertices had a part in: after these have changed.
  void forget(const std::vector<std::uint8_t>& changed, const Run& run);
  // Median circumradius of the triangles at the vertex alone.
  double own(Index vertex) const;
  // Logarithm of a triangle's circumradius over the typical one around its corners, at most 3.
  double log_ratio(const Triangle& triangle);
  double spread(const Triangle& triangle);

 private:
  static constexpr int around = 16;  // nearest neighbours whose triangles count

  LocalSize measure(Index vertex, std::vector<double>& radii) const;

  const Complex& complex_;
  const Neighbours& neighbours_;
  std::vector<LocalSize> known_;
  std::vector<LocalSize> least_;  // not more than those; empty until bounds were asked for
  std::vector<double> radii_;
};

}  // namespace rimline::exact
