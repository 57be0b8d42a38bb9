// SPDX-License-Identifier: GPL-3.0-or-later
// The test of one point the long way: a general eigen-solver, atan2, a pass for each step. The oracle of the
// library's fused pass.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline::simple {

struct Covariance {
  Point centroid;
  double lambda1 = 0, lambda2 = 0, lambda3 = 0;  // ascending
  Point v1, v2, v3;                              // orthonormal

  double delta() const {
    const double trace = lambda1 + lambda2 + lambda3;
    return trace > 0 ? lambda2 / trace : 0;
  }
};

inline Point column(const Eigen::Matrix3d& m, int c) { return {m(0, c), m(1, c), m(2, c)}; }

// Gives one coordinate the scale of its principal direction and a sign that the points decide.
inline void equalize(std::vector<UV>& image, double UV::*coordinate, double lambda, double largest) {
  // A direction without extent stays without: all angles are then 0 or pi, as they are on a line.
  const double scale = lambda > 1e-24 * largest ? 1 / std::sqrt(lambda) : 0;
  double third_moment = 0;
  for (const UV& p : image) third_moment += p.*coordinate * p.*coordinate * p.*coordinate;
  const double factor = third_moment < 0 ? -scale : scale;
  for (UV& p : image) p.*coordinate *= factor;
}

inline Covariance covariance(Points points, std::span<const Index> neighbours) {
  Covariance result;
  for (const Index j : neighbours) result.centroid = result.centroid + points[j];
  result.centroid = (1.0 / static_cast<double>(neighbours.size())) * result.centroid;

  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  for (const Index j : neighbours) {
    const Point offset = points[j] - result.centroid;
    const Eigen::Vector3d d(offset.x, offset.y, offset.z);
    sums += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sums);
  result.lambda1 = std::max(0.0, eigen.eigenvalues()[0]);
  result.lambda2 = std::max(0.0, eigen.eigenvalues()[1]);
  result.lambda3 = std::max(0.0, eigen.eigenvalues()[2]);
  result.v1 = column(eigen.eigenvectors(), 0);
  result.v2 = column(eigen.eigenvectors(), 1);
  result.v3 = column(eigen.eigenvectors(), 2);
  return result;
}

inline void flatten(Points points, Index point, std::span<const Index> neighbours, const Covariance& shape,
                    std::vector<UV>& image) {
  image.clear();
  for (const Index j : neighbours) {
    const Point offset = points[j] - points[point];
    image.push_back({dot(offset, shape.v3), dot(offset, shape.v2)});
  }
  equalize(image, &UV::u, shape.lambda3, shape.lambda3);
  equalize(image, &UV::v, shape.lambda2, shape.lambda3);
}

inline void count_sectors(std::span<const UV> image, int sectors, std::vector<int>& counts) {
  counts.assign(sectors, 0);
  for (const UV& p : image) {
    double turn = std::atan2(p.v, p.u) / (2 * std::numbers::pi);  // (-1/2, 1/2]
    if (turn < 0) turn += 1;
    // A tiny negative angle rounds to a whole turn, which is no sector of its own.
    ++counts[std::min(sectors - 1, static_cast<int>(turn * sectors))];
  }
}

}  // namespace rimline::simple
