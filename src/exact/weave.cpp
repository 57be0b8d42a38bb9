// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/weave.h"

#include <cmath>

namespace rimline::exact {
namespace {

Weave scaled(const Weave& a, double factor) { return {factor * a.xx, factor * a.xy, factor * a.yy}; }
double determinant(const Weave& a) { return a.xx * a.yy - a.xy * a.xy; }

Weave root(const Weave& a) {
  const double s = std::sqrt(determinant(a)), t = std::sqrt(a.xx + a.yy + 2 * s);
  return scaled({a.xx + s, a.xy, a.yy + s}, 1 / t);
}

// a b a, symmetric again.
Weave around(const Weave& a, const Weave& b) {
  const double px = a.xx * b.xx + a.xy * b.xy, py = a.xx * b.xy + a.xy * b.yy;
  const double qx = a.xy * b.xx + a.yy * b.xy, qy = a.xy * b.xy + a.yy * b.yy;
  return {px * a.xx + py * a.xy, px * a.xy + py * a.yy, qx * a.xy + qy * a.yy};
}

}  // namespace

// Where x and y are stretched so that v is as long as W v, with W the root of the weave, the sum of
// v v^T / |v|^4, far ones left out, is long in the directions in which points lie close. Stretching by its
// root evens that out; half of that a step does not overshoot.
Weave find_weave(const std::vector<Offset>& offsets) {
  constexpr int steps = 8;
  constexpr double least = 0.15;  // squared: what is closer than that is chance
  Weave weave;
  for (int i = 0; i < steps; ++i) {
    const Weave w = root(weave);
    Weave sum{0, 0, 0};
    for (const Offset& o : offsets) {
      const double x = w.xx * o.x + w.xy * o.y, y = w.xy * o.x + w.yy * o.y, squared = x * x + y * y + least;
      const double weight = std::exp(-squared) / (squared * squared);
      sum = {sum.xx + weight * x * x, sum.xy + weight * x * y, sum.yy + weight * y * y};
    }
    const double size = determinant(sum);
    if (!(size > 1e-12 * sum.xx * sum.yy)) break;  // on one line, or none
    weave = around(w, root(scaled(sum, 1 / std::sqrt(size))));
    weave = scaled(weave, 1 / std::sqrt(determinant(weave)));
  }
  return weave;
}

}  // namespace rimline::exact
