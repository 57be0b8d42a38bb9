// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/anisotropy.h"

#include <algorithm>
#include <cmath>

#include "base/model.h"
#include "local/frame.h"

namespace rimline {
namespace {

Anisotropy scaled(const Anisotropy& a, double factor) {
  return {factor * a.xx, factor * a.xy, factor * a.yy};
}
double determinant(const Anisotropy& a) { return a.xx * a.yy - a.xy * a.xy; }

Anisotropy root(const Anisotropy& a) {
  const double s = std::sqrt(determinant(a)), t = std::sqrt(a.xx + a.yy + 2 * s);
  return scaled({a.xx + s, a.xy, a.yy + s}, 1 / t);
}

// a b a, symmetric again.
Anisotropy around(const Anisotropy& a, const Anisotropy& b) {
  const double px = a.xx * b.xx + a.xy * b.xy, py = a.xx * b.xy + a.xy * b.yy;
  const double qx = a.xy * b.xx + a.yy * b.xy, qy = a.xy * b.xy + a.yy * b.yy;
  return {px * a.xx + py * a.xy, px * a.xy + py * a.yy, qx * a.xy + qy * a.yy};
}

}  // namespace

// Where x and y are stretched so that v is as long as W v, with W the root of the anisotropy, the sum of
// v v^T / |v|^4, far ones left out, is long in the directions in which points lie close. Stretching by its
// root evens that out; half of that a step does not overshoot.
Anisotropy find_anisotropy(const std::vector<Offset>& offsets) {
  constexpr int steps = 8;  // [speed]
  constexpr double least = model::anisotropy_core;
  Anisotropy anisotropy;
  for (int i = 0; i < steps; ++i) {
    const Anisotropy w = root(anisotropy);
    Anisotropy sum{0, 0, 0};
    for (const Offset& o : offsets) {
      const double x = w.xx * o.x + w.xy * o.y, y = w.xy * o.x + w.yy * o.y, squared = x * x + y * y + least;
      const double weight = std::exp(-squared) / (squared * squared);
      sum = {sum.xx + weight * x * x, sum.xy + weight * x * y, sum.yy + weight * y * y};
    }
    const double size = determinant(sum);
    if (!(size > 1e-12 * sum.xx * sum.yy)) break;  // on one line, or none [guard]
    anisotropy = around(w, root(scaled(sum, 1 / std::sqrt(size))));
    anisotropy = scaled(anisotropy, 1 / std::sqrt(determinant(anisotropy)));
  }
  return anisotropy;
}

double log_ratio(const Anisotropy& anisotropy) {
  return std::acosh(std::max(1.0, (anisotropy.xx + anisotropy.yy) / 2));  // half the sum of e^r and e^-r
}

double anisotropy_at(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                     Index point) {
  constexpr int count = model::more_neighbours;
  const auto near = neighbours.of(point, std::min(count, neighbours.k));
  const Frame frame = fit_frame(points, near, point);
  std::vector<Offset> offsets;
  const auto take = [&](Index from) {
    for (const Index v : neighbours.of(from, std::min(count, neighbours.k))) {
      const Point d = (1 / spacing[point]) * (points[v] - points[from]);
      offsets.push_back({dot(d, frame.u), dot(d, frame.v)});
    }
  };
  take(point);
  for (const Index v : near) take(v);
  return log_ratio(find_anisotropy(offsets));
}

double mean_anisotropy(const std::vector<double>& at_points) {
  double sum = 0;
  for (const double r : at_points) sum += r;
  const double mean = sum / static_cast<double>(at_points.size());
  return mean >= model::anisotropy_least ? mean : 0;
}

}  // namespace rimline
