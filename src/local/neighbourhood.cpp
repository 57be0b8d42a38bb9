// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "base/multiversioning.h"
#include "base/vec.h"

namespace rimline {
namespace {

// An eigenvalue below this share of the largest is rounding error.
constexpr double least_share = 1e-13;  // [guard]

// Even and odd neighbours are summed apart. There is at least one pair, so that the loop over pairs is always
// entered and the compiler can vectorize the loop over lanes.

// The sums of squares about the centroid of k points: those about the point less those of the centroid, k
// times. The offsets, `count` of them, are those of the points and zeros.
RIMLINE_WIDE void add_squares(const Lanes* x, const Lanes* y, const Lanes* z, std::size_t count, double k,
                              CovarianceLanes& m) {
  for (int l = 0; l < lanes; ++l) {
    Point sum[2];
    Covariance squares[2];
    std::size_t j = 0;
    do {
      for (int odd = 0; odd < 2; ++odd) {
        const Point d{x[j + odd][l], y[j + odd][l], z[j + odd][l]};
        sum[odd] = sum[odd] + d;
        Covariance& s = squares[odd];
        s.xx += d.x * d.x, s.xy += d.x * d.y, s.xz += d.x * d.z;
        s.yy += d.y * d.y, s.yz += d.y * d.z, s.zz += d.z * d.z;
      }
      j += 2;
    } while (j < count);
    const Point total = sum[0] + sum[1];
    const Point mean = 1 / k * total;
    m.xx[l] = squares[0].xx + squares[1].xx - total.x * mean.x;
    m.xy[l] = squares[0].xy + squares[1].xy - total.x * mean.y;
    m.xz[l] = squares[0].xz + squares[1].xz - total.x * mean.z;
    m.yy[l] = squares[0].yy + squares[1].yy - total.y * mean.y;
    m.yz[l] = squares[0].yz + squares[1].yz - total.y * mean.z;
    m.zz[l] = squares[0].zz + squares[1].zz - total.z * mean.z;
  }
}

// One coordinate of the image, along a principal direction, scaled to unit variability. The third moment
// gives its sign.
RIMLINE_WIDE void find_factor(const Lanes* x, const Lanes* y, const Lanes* z, std::size_t count,
                              const PrincipalAxesLanes& axes, int direction, Lanes& factor) {
  Lanes moment;
  for (int l = 0; l < lanes; ++l) {
    const Point axis{axes.x[direction][l], axes.y[direction][l], axes.z[direction][l]};
    double third_moment[2] = {0, 0};
    std::size_t j = 0;
    do {
      for (int odd = 0; odd < 2; ++odd) {
        const double along = x[j + odd][l] * axis.x + y[j + odd][l] * axis.y + z[j + odd][l] * axis.z;
        third_moment[odd] += along * along * along;
      }
      j += 2;
    } while (j < count);
    moment[l] = third_moment[0] + third_moment[1];
  }
  for (int l = 0; l < lanes; ++l) {
    // A direction without extent keeps none: all angles are then 0 or pi, as on a line.
    const double lambda = axes.lambda[direction][l];
    const double scale = lambda > least_share * axes.lambda[2][l] ? 1 / std::sqrt(lambda) : 0;
    factor[l] = moment[l] < 0 ? -scale : scale;
  }
}

RIMLINE_WIDE void project(const Lanes* x, const Lanes* y, const Lanes* z, std::size_t count,
                          const PrincipalAxesLanes& axes, int direction, const Lanes& factor,
                          Lanes* __restrict image) {
  const Lanes &ax = axes.x[direction], &ay = axes.y[direction], &az = axes.z[direction];
  for (std::size_t j = 0; j < count; ++j) {
    for (int l = 0; l < lanes; ++l) {
      image[j][l] = factor[l] * (x[j][l] * ax[l] + y[j][l] * ay[l] + z[j][l] * az[l]);
    }
  }
}

// Of the centroid of k points over the point, along the first axis.
RIMLINE_WIDE void mean_height(const Lanes* x, const Lanes* y, const Lanes* z, std::size_t count, double k,
                              const PrincipalAxesLanes& axes, Lanes& height) {
  for (int l = 0; l < lanes; ++l) {
    const Point normal{axes.x[0][l], axes.y[0][l], axes.z[0][l]};
    Point sum[2];
    std::size_t j = 0;
    do {
      for (int odd = 0; odd < 2; ++odd)
        sum[odd] = sum[odd] + Point{x[j + odd][l], y[j + odd][l], z[j + odd][l]};
      j += 2;
    } while (j < count);
    height[l] = std::abs(dot(sum[0] + sum[1], normal)) / k;
  }
}

}  // namespace

double delta(const PrincipalAxes& axes) {
  const double trace = axes.lambda[0] + axes.lambda[1] + axes.lambda[2];
  return trace > 0 ? axes.lambda[1] / trace : 0;
}

void Neighbourhoods::gather(Points points, const Neighbours& neighbours, Index first, Index end) {
  for (int l = 0; l < std::min(lanes, end - first); ++l) {
    const Point p = points[first + l];
    const auto ids = neighbours.of(first + l, k_);
    for (int j = 0; j < k_; ++j) {
      const Point& q = points[ids[j]];
      x_[j][l] = q.x - p.x;
      y_[j][l] = q.y - p.y;
      z_[j][l] = q.z - p.z;
    }
  }
}

void Neighbourhoods::sum_squares(int count, CovarianceLanes& m) const {
  add_squares(x_.data(), y_.data(), z_.data(), x_.size(), count, m);
}

void Neighbourhoods::find_axes(PrincipalAxesLanes& axes) const {
  CovarianceLanes m;
  sum_squares(k_, m);
  principal_axes(m, axes);
  for (Lanes& lambda : axes.lambda) {
    for (double& number : lambda.number) number = std::max(0.0, number);
  }
}

void Neighbourhoods::find_heights(const PrincipalAxesLanes& axes, Lanes& height) const {
  mean_height(x_.data(), y_.data(), z_.data(), x_.size(), k_, axes, height);
}

void Neighbourhoods::flatten(const PrincipalAxesLanes& axes) {
  for (const int direction : {2, 1}) {
    Lanes factor;
    find_factor(x_.data(), y_.data(), z_.data(), x_.size(), axes, direction, factor);
    project(x_.data(), y_.data(), z_.data(), x_.size(), axes, direction, factor,
            direction == 2 ? u_.data() : v_.data());
  }
}

}  // namespace rimline
