// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/conformal_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rimline {
namespace {

Eigen::Vector2d unit(ConformalTriangle::Complex z) {
  const double size = std::abs(z);
  return size > 0 ? Eigen::Vector2d(z.real() / size, z.imag() / size) : Eigen::Vector2d(1, 0);
}

// Projects a symmetric 2x2 matrix to a positive semidefinite one.
Eigen::Matrix2d positive_part(double a, double b, double d) {
  const double middle = (a + d) / 2, radius = std::hypot((a - d) / 2, b);
  const double high = middle + radius, low = middle - radius;
  Eigen::Matrix2d m;
  m << a, b, b, d;
  if (low >= 0) return m;
  if (high <= 0) return Eigen::Matrix2d::Zero();
  // (m - low) is (high - low) times the projector on the eigenvector of `high`.
  return high / (high - low) * (m - low * Eigen::Matrix2d::Identity());
}

}  // namespace

ConformalTriangle::ConformalTriangle(const std::array<Point, 3>& p, double isometry) : isometry_(isometry) {
  constexpr double flattest = 1e-3;
  const Point e = p[1] - p[0], f = p[2] - p[0], g = f - e;
  const double longest = std::sqrt(std::max({dot(e, e), dot(f, f), dot(g, g)}));
  const double base = norm(e);
  if (!(base > 0)) return;  // without area it has no slopes and is ignored
  const double height = std::max(norm(cross(e, f)) / base, flattest * longest);
  const Complex z0 = 0, z1 = base, z2{dot(e, f) / base, height};
  area_ = base * height / 2;
  // The gradient of the hat function at a corner is its opposite side turned by a right angle, over twice the
  // area; d/dz is half of d/dx - i d/dy.
  const auto slope = [&](Complex from, Complex to) {
    return std::conj(Complex{0, 1} * (to - from)) / (4 * area_);
  };
  slope_ = {slope(z1, z2), slope(z2, z0), slope(z0, z1)};
}

void ConformalTriangle::coefficients(const Corners& uv, Complex& alpha, Complex& beta) const {
  alpha = beta = 0;
  for (int i = 0; i < 3; ++i) {
    // From the first corner: what is far from the origin keeps its digits.
    const Complex w{uv[i].u - uv[0].u, uv[i].v - uv[0].v};
    alpha += slope_[i] * w;
    beta += std::conj(slope_[i]) * w;
  }
}

double ConformalTriangle::value(const Corners& uv) const {
  Complex alpha, beta;
  coefficients(uv, alpha, beta);
  const double p = std::norm(alpha), q = std::norm(beta);
  const double d = p - q;
  if (!(d > 0)) return std::numeric_limits<double>::infinity();
  return (p + q) / d + isometry_ * (p + q) / 2 * (1 + 1 / (d * d));
}

void ConformalTriangle::derivatives(const Corners& uv, Gradient& gradient, Hessian& hessian) const {
  Complex alpha, beta;
  coefficients(uv, alpha, beta);
  const double a = std::abs(alpha), b = std::abs(beta), p = a * a, q = b * b, d = p - q;
  // By the sum s = p + q and by d, once and twice; then by p and by q.
  const double s = p + q, k = isometry_;
  const double by_s = 1 / d + k / 2 * (1 + 1 / (d * d)), by_d = -s / (d * d) - k * s / (d * d * d);
  const double by_sd = -1 / (d * d) - k / (d * d * d);
  const double by_dd = 2 * s / (d * d * d) + 3 * k * s / (d * d * d * d);
  const double by_p = by_s + by_d, by_q = by_s - by_d;
  const double by_pp = by_dd + 2 * by_sd, by_qq = by_dd - 2 * by_sd, by_pq = -by_dd;
  // The value depends on |alpha| and |beta| alone: along each it curves as the function of two variables
  // does, across them by the slope over the radius.
  const Eigen::Matrix2d along =
      positive_part(2 * by_p + 4 * p * by_pp, 4 * a * b * by_pq, 2 * by_q + 4 * q * by_qq);
  const Eigen::Vector2d ua = unit(alpha), ub = unit(beta);
  const auto outer = [](const Eigen::Vector2d& x, const Eigen::Vector2d& y) -> Eigen::Matrix2d {
    return x * y.transpose();
  };
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  Eigen::Matrix4d h;
  h.topLeftCorner<2, 2>() = along(0, 0) * outer(ua, ua) + std::max(0.0, 2 * by_p) * (one - outer(ua, ua));
  h.bottomRightCorner<2, 2>() = along(1, 1) * outer(ub, ub) + std::max(0.0, 2 * by_q) * (one - outer(ub, ub));
  h.topRightCorner<2, 2>() = along(0, 1) * outer(ua, ub);
  h.bottomLeftCorner<2, 2>() = h.topRightCorner<2, 2>().transpose();
  Eigen::Vector4d g;
  g << 2 * by_p * alpha.real(), 2 * by_p * alpha.imag(), 2 * by_q * beta.real(), 2 * by_q * beta.imag();
  Eigen::Matrix<double, 4, 6> m;  // (alpha, beta) of the corners
  for (int i = 0; i < 3; ++i) {
    const double re = slope_[i].real(), im = slope_[i].imag();
    m.block<4, 2>(0, 2 * i) << re, -im, im, re, re, im, -im, re;
  }
  gradient = m.transpose() * g;
  hessian = m.transpose() * h * m;
}

}  // namespace rimline
