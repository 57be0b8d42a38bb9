// SPDX-License-Identifier: GPL-3.0-or-later
// How large a triangle is against those around it.
#pragma once

#include <vector>

#include "exact/complex.h"
#include "rimline/neighbours.h"

namespace rimline::exact {

// The circumradii of the triangles around a point: at it and at its 16 nearest neighbours.
struct LocalSize {
  double median = -1;
  double spread = 0;  // interquartile range over median: about 0 on a grid, 0.3 on scans, 0.5 at random
};

// Spacing alone does not say which triangle is too large: a rim triangle of one spacing closes a true notch
// on an even sample and is nothing unusual on a random one. Values are computed when first asked for.
class LocalSizes {
 public:
  LocalSizes(const Complex& complex, const Neighbours& neighbours)
      : complex_(complex), neighbours_(neighbours), known_(complex.vertices()) {}

  const LocalSize& at(Index vertex);
  // Median circumradius of the triangles at the vertex alone.
  double own(Index vertex);
  // Logarithm of a triangle's circumradius over the median around its corners, at most 3.
  double log_ratio(const Triangle& triangle);
  double spread(const Triangle& triangle);

 private:
  const Complex& complex_;
  const Neighbours& neighbours_;
  std::vector<LocalSize> known_;
  std::vector<double> radii_;
};

}  // namespace rimline::exact
