// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace rimline {
namespace {

Point times(const Covariance& m, Point p) {
  return {m.xx * p.x + m.xy * p.y + m.xz * p.z, m.xy * p.x + m.yy * p.y + m.yz * p.z,
          m.xz * p.x + m.yz * p.y + m.zz * p.z};
}

// The largest root of x^3 - 3 x - 2 r for r in [0, 1]. It lies in [sqrt(3), 2], where the cubic is convex and
// steep; the start is never below it, so Newton's steps fall to it without leaving. Four of them are enough.
double largest_root(double r) {
  double x = std::min(2.0, 1.7320508075688774 + r / 3);
  for (int step = 0; step < 4; ++step) x -= (x * (x * x - 3) - 2 * r) / (3 * (x * x - 1));
  return x;
}

// The unit vector that a matrix of rank two sends to zero: across its two most independent rows.
Point null_vector(const Covariance& m) {
  const Point a{m.xx, m.xy, m.xz}, b{m.xy, m.yy, m.yz}, c{m.xz, m.yz, m.zz};
  Point best = cross(a, b);
  for (const Point other : {cross(b, c), cross(c, a)}) {
    if (dot(other, other) > dot(best, best)) best = other;
  }
  return 1 / norm(best) * best;
}

// Any unit vector across v.
Point across(Point v) {
  const Point p = std::abs(v.x) > std::abs(v.y) ? Point{-v.z, 0, v.x} : Point{0, v.z, -v.y};
  return 1 / norm(p) * p;
}

// The axes within the plane of the unit vectors p and q, by one rotation: first the larger eigenvalue.
void plane_axes(const Covariance& m, Point& p, Point& q, double& large, double& small) {
  const double pp = dot(p, times(m, p)), pq = dot(p, times(m, q)), qq = dot(q, times(m, q));
  const double half_gap = 0.5 * (pp - qq);
  const double root = std::sqrt(half_gap * half_gap + pq * pq);
  // The vector (c, s) of the larger one, from the row of its equations that does not cancel.
  double c = half_gap >= 0 ? root + half_gap : pq, s = half_gap >= 0 ? pq : root - half_gap;
  const double length = std::sqrt(c * c + s * s);
  c = length > 0 ? c / length : 1, s = length > 0 ? s / length : 0;
  large = 0.5 * (pp + qq) + root;
  small = 0.5 * (pp + qq) - root;
  std::tie(p, q) = std::pair(c * p + s * q, c * q - s * p);
}

}  // namespace

PrincipalAxes principal_axes(const Covariance& given) {
  PrincipalAxes axes{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double size = std::max({std::abs(given.xx), std::abs(given.xy), std::abs(given.xz),
                                std::abs(given.yy), std::abs(given.yz), std::abs(given.zz)});
  if (!(size > 0)) return axes;
  const Covariance m{given.xx / size, given.xy / size, given.xz / size,
                          given.yy / size, given.yz / size, given.zz / size};
  // (m - mean) / scale has trace 0 and eigenvalues in [-2, 2]; r is half its determinant.
  const double mean = (m.xx + m.yy + m.zz) / 3;
  const double x = m.xx - mean, y = m.yy - mean, z = m.zz - mean;
  const double scale = std::sqrt((x * x + y * y + z * z + 2 * (m.xy * m.xy + m.xz * m.xz + m.yz * m.yz)) / 6);
  if (!(scale > 1e-15 * std::abs(mean))) {
    for (double& lambda : axes.lambda) lambda = size * mean;
    return axes;
  }
  const double determinant =
      x * (y * z - m.yz * m.yz) - m.xy * (m.xy * z - m.yz * m.xz) + m.xz * (m.xy * m.yz - y * m.xz);
  const double r = std::clamp(0.5 * determinant / (scale * scale * scale), -1.0, 1.0);
  const double apart = (r < 0 ? -scale : scale) * largest_root(std::abs(r));

  const Point v = null_vector({x - apart, m.xy, m.xz, y - apart, m.yz, z - apart});
  Point p = across(v), q = cross(v, p);
  double large = 0, small = 0;
  plane_axes(m, p, q, large, small);
  const double alone = dot(v, times(m, v));
  axes = r < 0 ? PrincipalAxes{{size * alone, size * small, size * large}, {v, q, p}}
               : PrincipalAxes{{size * small, size * large, size * alone}, {q, p, v}};
  return axes;
}

}  // namespace rimline
