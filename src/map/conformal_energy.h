// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of a triangle: half of s1 / s2 + s2 / s1 of the singular values of its map, which is 1 where
// angles are kept and grows without bound towards a flipped triangle (the most isometric parameterization:
// Hormann & Greiner 2000); and a share of the symmetric Dirichlet energy, which is least where lengths are
// kept.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "rimline/points.h"

namespace rimline {

// A triangle of the surface laid flat. Its map w = alpha z + beta conj(z) has s1 = |alpha| + |beta| and
// s2 = |alpha| - |beta|, and alpha and beta are linear in where the corners go.
class ConformalTriangle {
 public:
  using Complex = std::complex<double>;
  using Corners = std::array<UV, 3>;
  using Gradient = Eigen::Matrix<double, 6, 1>;  // u and v of corner 0, then 1, then 2
  using Hessian = Eigen::Matrix<double, 6, 6>;

  // One whose height is below a thousandth of its longest side is taken to have that height.
  // `isometry` is the weight of (s1^2 + s2^2 + 1 / s1^2 + 1 / s2^2) / 4.
  explicit ConformalTriangle(const std::array<Point, 3>& corners, double isometry = 0);

  double area() const { return area_; }  // 0 where its first two corners are one: then nothing else holds
  // (|alpha|^2 + |beta|^2) / (|alpha|^2 - |beta|^2) where isometry is 0; infinite where the triangle is
  // turned over or flat.
  double value(const Corners& uv) const;
  // The gradient there, and the Hessian with its negative eigenvalues taken out. Only where it is finite.
  void derivatives(const Corners& uv, Gradient& gradient, Hessian& hessian) const;

 private:
  void coefficients(const Corners& uv, Complex& alpha, Complex& beta) const;

  std::array<Complex, 3> slope_;  // alpha = sum of slope_[i] w[i], beta = sum of conj(slope_[i]) w[i]
  double area_ = 0, isometry_ = 0;
};

}  // namespace rimline
