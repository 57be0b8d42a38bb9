// SPDX-License-Identifier: GPL-3.0-or-later
// The discrete neighbourhood of a point, laid flat: sections 2.2 and 2.3.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

// Covariance of the k neighbours (the point itself left out), section 2.2. Eigenvalues ascend as in the
// paper: lambda_1 belongs to the normal of the least squares plane T.
struct Covariance {
  Point centroid;
  double lambda1 = 0, lambda2 = 0, lambda3 = 0;  // of the sums of squares, squared unit of the points
  Point v1, v2, v3;                              // orthonormal

  // Assumption 2.4's share of the second principal direction; 0 where all neighbours coincide.
  double delta() const {
    const double trace = lambda1 + lambda2 + lambda3;
    return trace > 0 ? lambda2 / trace : 0;
  }
};

Covariance covariance(Points points, std::span<const Index> neighbours);

// The image of the neighbours under h = sigma after pi, about the image of the point: pi projects on T and
// sigma gives v3 and v2 equal variability. First coordinate along v3, second along v2. Each direction points
// to where the third moment of the offsets is positive, so that turning or mirroring the input changes
// nothing; the paper leaves this open [ours, docs/departures.md].
void flatten(Points points, Index point, std::span<const Index> neighbours, const Covariance& shape,
             std::vector<UV>& image);

}  // namespace rimline
