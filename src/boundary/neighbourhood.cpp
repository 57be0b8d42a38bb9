// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace rimline {
namespace {

// Sums are kept in two lanes, even and odd neighbours, which is what the smallest vector registers hold.
struct Sum {
  double lane[2] = {0, 0};

  double total() const { return lane[0] + lane[1]; }
};

// Below this share of the largest eigenvalue another is rounding.
constexpr double least_share = 1e-13;

}  // namespace

double delta(const PrincipalAxes& axes) {
  const double trace = axes.lambda[0] + axes.lambda[1] + axes.lambda[2];
  return trace > 0 ? axes.lambda[1] / trace : 0;
}

void Neighbourhood::gather(Points points, Index point, std::span<const Index> neighbours) {
  const Point p = points[point];
  for (int j = 0; j < k_; ++j) {
    const Point& q = points[neighbours[j]];
    x_[j] = q.x - p.x;
    y_[j] = q.y - p.y;
    z_[j] = q.z - p.z;
  }
}

PrincipalAxes Neighbourhood::axes() const {
  Sum x, y, z, xx, xy, xz, yy, yz, zz;
  for (std::size_t j = 0; j < x_.size(); j += 2) {
    for (int l = 0; l < 2; ++l) {
      const double dx = x_[j + l], dy = y_[j + l], dz = z_[j + l];
      x.lane[l] += dx, y.lane[l] += dy, z.lane[l] += dz;
      xx.lane[l] += dx * dx, xy.lane[l] += dx * dy, xz.lane[l] += dx * dz;
      yy.lane[l] += dy * dy, yz.lane[l] += dy * dz, zz.lane[l] += dz * dz;
    }
  }
  // About the centroid: the sums of squares about the point less those of the centroid, k times.
  const Point sum{x.total(), y.total(), z.total()};
  const Point mean = (1.0 / k_) * sum;
  PrincipalAxes axes =
      principal_axes({xx.total() - sum.x * mean.x, xy.total() - sum.x * mean.y, xz.total() - sum.x * mean.z,
                      yy.total() - sum.y * mean.y, yz.total() - sum.y * mean.z, zz.total() - sum.z * mean.z});
  for (double& lambda : axes.lambda) lambda = std::max(0.0, lambda);
  return axes;
}

void Neighbourhood::flatten(const PrincipalAxes& axes) {
  project(axes.v[2], axes.lambda[2], axes.lambda[2], u_);
  project(axes.v[1], axes.lambda[1], axes.lambda[2], v_);
}

// One coordinate of the image, with the scale of its principal direction and a sign that the points decide.
void Neighbourhood::project(Point axis, double lambda, double largest, std::vector<double>& image) const {
  Sum third_moment;
  for (std::size_t j = 0; j < x_.size(); j += 2) {
    for (int l = 0; l < 2; ++l) {
      const double along = x_[j + l] * axis.x + y_[j + l] * axis.y + z_[j + l] * axis.z;
      image[j + l] = along;
      third_moment.lane[l] += along * along * along;
    }
  }
  // A direction without extent stays without: all angles are then 0 or pi, as they are on a line.
  const double scale = lambda > least_share * largest ? 1 / std::sqrt(lambda) : 0;
  const double factor = third_moment.total() < 0 ? -scale : scale;
  for (double& coordinate : image) coordinate *= factor;
}

}  // namespace rimline
