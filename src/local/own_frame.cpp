// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/own_frame.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "local/principal_axes.h"

namespace rimline {
namespace {

SecondMoments products(Point d) { return {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z}; }

ThirdMoments triple_products(Point d) {
  const auto [xx, xy, xz, yy, yz, zz] = products(d);
  return {xx * d.x, xx * d.y, xx * d.z, xy * d.y, xy * d.z, xz * d.z, yy * d.y, yy * d.z, yz * d.z, zz * d.z};
}

template <std::size_t size>
void add(std::array<double, size>& sum, double weight, const std::array<double, size>& more) {
  for (std::size_t i = 0; i < size; ++i) sum[i] += weight * more[i];
}

// Sums of three products of a coordinate and a second moment, in the order of Moments::third.
ThirdMoments crossed(Point d, const SecondMoments& m) {
  const auto [xx, xy, xz, yy, yz, zz] = m;
  return {3 * d.x * xx,
          2 * d.x * xy + d.y * xx,
          2 * d.x * xz + d.z * xx,
          2 * d.y * xy + d.x * yy,
          d.x * yz + d.y * xz + d.z * xy,
          2 * d.z * xz + d.x * zz,
          3 * d.y * yy,
          2 * d.y * yz + d.z * yy,
          2 * d.z * yz + d.y * zz,
          3 * d.z * zz};
}

// Two passes: the mean first.
Moments moments_of_part(Points part) {
  Moments moments;
  moments.count = static_cast<double>(part.size());
  Point sum{};
  for (const Point p : part) sum = sum + p;
  moments.mean = (1 / moments.count) * sum;
  for (const Point p : part) {
    add(moments.second, 1, products(p - moments.mean));
    add(moments.third, 1, triple_products(p - moments.mean));
  }
  return moments;
}

// The third moment along a direction.
double skew_along(Point a, const ThirdMoments& third) {
  constexpr ThirdMoments times{1, 3, 3, 3, 6, 3, 1, 3, 3, 1};  // [layout] of each product
  const ThirdMoments products = triple_products(a);
  double sum = 0;
  for (std::size_t i = 0; i < third.size(); ++i) sum += times[i] * products[i] * third[i];
  return sum;
}

}  // namespace

Moments& Moments::operator+=(const Moments& other) {
  if (other.count == 0) return *this;
  if (count == 0) return *this = other;
  const double a = count, b = other.count, all = a + b;
  const Point d = other.mean - mean;
  add(third, 1, other.third);
  add(third, a * b * (a - b) / (all * all), triple_products(d));
  add(third, a / all, crossed(d, other.second));
  add(third, -b / all, crossed(d, second));
  add(second, 1, other.second);
  add(second, a * b / all, products(d));
  mean = mean + (b / all) * d;
  count = all;
  return *this;
}

Moments moments_of(Points points, const Run& run) {
  constexpr std::size_t in_part = 16384;  // [speed] the same for any number of threads
  std::vector<Moments> parts((points.size() + in_part - 1) / in_part);
  parallel_tasks(parts.size(), Stage::Survey, run, [&](std::size_t k) {
    parts[k] = moments_of_part(points.subspan(k * in_part, std::min(in_part, points.size() - k * in_part)));
  });
  run.check_cancel();
  Moments sum;
  for (const Moments& part : parts) sum += part;
  return sum;
}

OwnFrame own_frame(const Moments& moments) {
  constexpr double flat = 1e-12;  // of the variance in the middle direction [guard]
  OwnFrame frame;
  frame.centre = moments.mean;
  frame.count = moments.count;
  SecondMoments variance{};
  add(variance, 1 / moments.count, moments.second);
  const auto [xx, xy, xz, yy, yz, zz] = variance;
  const double extent = std::sqrt(xx + yy + zz);
  if (!(extent > 0) || !std::isfinite(extent)) return frame;
  frame.extent = extent;
  const PrincipalAxes found = principal_axes({xx, xy, xz, yy, yz, zz});
  frame.is_flat = found.lambda[0] <= flat * found.lambda[1];
  frame.axes = {found.v[2], found.v[1], cross(found.v[2], found.v[1])};
  for (const int axis : {0, 1}) {
    if (skew_along(frame.axes[axis], moments.third) < 0) frame.axes[axis] = -1 * frame.axes[axis];
  }
  frame.axes[2] = cross(frame.axes[0], frame.axes[1]);
  return frame;
}

OwnFrame own_frame(Points points, const Run& run) { return own_frame(moments_of(points, run)); }

// Mixes the position in steps of a 3,000th of the extent: neighbouring points get different numbers, and
// rounding changes hardly any.
double strewn(const OwnFrame& frame, Point point) {
  constexpr double steps = 3000, a = 0.7548776662466927, b = 0.5698402909980532;  // [layout]
  const Point at = (steps / frame.extent) * frame.in(point - frame.centre);
  const double mix = a * at.x + b * at.y + (1 - b) * at.z;
  return mix - std::floor(mix);
}

}  // namespace rimline
