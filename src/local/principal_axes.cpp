// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/principal_axes.h"

#include <algorithm>
#include <cmath>

#include "base/multiversioning.h"

namespace rimline {
namespace {

// Both alternatives are computed and one is chosen, without branches, so that the compiler can vectorize the
// loop over lanes.

inline Point times(const Covariance& m, Point p) {
  return {m.xx * p.x + m.xy * p.y + m.xz * p.z, m.xy * p.x + m.yy * p.y + m.yz * p.z,
          m.xz * p.x + m.yz * p.y + m.zz * p.z};
}

inline double larger(double a, double b) { return a < b ? b : a; }

// The largest root of x^3 - 3 x - 2 r for r in [0, 1]. It lies in [sqrt(3), 2], where the cubic is convex and
// steep; the start is never below it, so Newton's steps fall to it without leaving. Four of them are enough.
inline double largest_root(double r) {
  const double start = 1.7320508075688774 + r / 3;  // [layout] root of 3
  double x = start < 2 ? start : 2;
  for (int step = 0; step < 4; ++step) x -= (x * (x * x - 3) - 2 * r) / (3 * (x * x - 1));
  return x;
}

// The unit vector in the kernel of a matrix of rank two: the cross product of its two most independent rows.
inline Point null_vector(const Covariance& m) {
  const Point a{m.xx, m.xy, m.xz}, b{m.xy, m.yy, m.yz}, c{m.xz, m.yz, m.zz};
  const Point ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const Point first = choose(dot(bc, bc) > dot(ab, ab), bc, ab);
  const Point best = choose(dot(ca, ca) > dot(first, first), ca, first);
  return 1 / norm(best) * best;
}

// Any unit vector across v.
inline Point across(Point v) {
  const Point p = choose(std::abs(v.x) > std::abs(v.y), {-v.z, 0, v.x}, {0, v.z, -v.y});
  return 1 / norm(p) * p;
}

// The axes within the plane of the unit vectors p and q, by one rotation: first the larger eigenvalue.
inline void plane_axes(const Covariance& m, Point& p, Point& q, double& large, double& small) {
  const double pp = dot(p, times(m, p)), pq = dot(p, times(m, q)), qq = dot(q, times(m, q));
  const double half_gap = 0.5 * (pp - qq);
  const double root = std::sqrt(half_gap * half_gap + pq * pq);
  // The vector (c, s) of the larger one, from the row of its equations that does not cancel.
  const double along = half_gap >= 0 ? root + half_gap : pq, aside = half_gap >= 0 ? pq : root - half_gap;
  const double length = std::sqrt(along * along + aside * aside);
  const double c = length > 0 ? along / length : 1, s = length > 0 ? aside / length : 0;
  large = 0.5 * (pp + qq) + root;
  small = 0.5 * (pp + qq) - root;
  const Point turned = c * p + s * q;
  q = c * q - s * p;
  p = turned;
}

[[gnu::always_inline]] inline PrincipalAxes axes_of(const Covariance& given) {
  const double size = larger(
      larger(larger(std::abs(given.xx), std::abs(given.xy)), larger(std::abs(given.xz), std::abs(given.yy))),
      larger(std::abs(given.yz), std::abs(given.zz)));
  const double unit = size > 0 ? size : 1;
  const Covariance m{given.xx / unit, given.xy / unit, given.xz / unit,
                     given.yy / unit, given.yz / unit, given.zz / unit};
  // (m - mean) / scale has trace 0 and eigenvalues in [-2, 2]; r is half its determinant.
  const double mean = (m.xx + m.yy + m.zz) / 3;
  const double x = m.xx - mean, y = m.yy - mean, z = m.zz - mean;
  const double scale =
      std::sqrt((x * x + y * y + z * z + 2 * (m.xy * m.xy + m.xz * m.xz + m.yz * m.yz)) / 6);  // [layout]
  const bool differ = scale > 1e-15 * std::abs(mean);  // the eigenvalues [guard]
  const double determinant =
      x * (y * z - m.yz * m.yz) - m.xy * (m.xy * z - m.yz * m.xz) + m.xz * (m.xy * m.yz - y * m.xz);
  const double ratio = 0.5 * determinant / (scale * scale * scale);
  const double r = ratio < -1 ? -1 : ratio > 1 ? 1 : ratio;
  const double apart = (r < 0 ? -scale : scale) * largest_root(std::abs(r));

  const Point v = null_vector({x - apart, m.xy, m.xz, y - apart, m.yz, z - apart});
  Point p = across(v), q = cross(v, p);
  double large = 0, small = 0;
  plane_axes(m, p, q, large, small);
  const double alone = dot(v, times(m, v));
  const bool least = r < 0;  // the one apart
  return {{size * (differ ? least ? alone : small : mean), size * (differ ? least ? small : large : mean),
           size * (differ ? least ? large : alone : mean)},
          {choose(differ, choose(least, v, q), {1, 0, 0}), choose(differ, choose(least, q, p), {0, 1, 0}),
           choose(differ, choose(least, p, v), {0, 0, 1})}};
}

}  // namespace

PrincipalAxes principal_axes(const Covariance& m) { return axes_of(m); }

RIMLINE_WIDE void principal_axes(const CovarianceLanes& m, PrincipalAxesLanes& axes) {
  for (int l = 0; l < lanes; ++l) {
    const PrincipalAxes a = axes_of({m.xx[l], m.xy[l], m.xz[l], m.yy[l], m.yz[l], m.zz[l]});
    for (int i = 0; i < 3; ++i) {
      axes.lambda[i][l] = a.lambda[i];
      axes.x[i][l] = a.v[i].x;
      axes.y[i][l] = a.v[i].y;
      axes.z[i][l] = a.v[i].z;
    }
  }
}

}  // namespace rimline
