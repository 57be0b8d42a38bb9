// SPDX-License-Identifier: GPL-3.0-or-later
// A Moebius strip: a segment that makes half a turn while its centre goes around the unit circle. Chart: u is
// the angle about the z axis, v the place on the segment; (u + 2 pi, v) is (u, -v).
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "sample/surface.h"

namespace rimline {
namespace {

using std::numbers::pi;
constexpr double half_width = 0.35;
constexpr double band = 0.3;  // of the strip along its rim, which is an annulus

double speed(double u, double v) { return std::hypot(1 + v * std::cos(u / 2), v / 2); }

// Length of the rim from 0 to u, u in [0, 4 pi], by the trapezoidal rule.
std::vector<double> rim_length(int steps) {
  std::vector<double> length(steps + 1, 0);
  const double step = 4 * pi / steps;
  for (int i = 0; i < steps; ++i) {
    length[i + 1] = length[i] + step * (speed(i * step, half_width) + speed((i + 1) * step, half_width)) / 2;
  }
  return length;
}

// The band along the rim laid out as an annulus, at true length along the rim.
UV annulus(UV at, const std::vector<double>& length) {
  if (at.v < 0) at = {at.u + 2 * pi, -at.v};
  const double place = std::clamp(at.u / (4 * pi), 0.0, 1.0) * static_cast<double>(length.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), length.size() - 2);
  const double along = length[i] + (place - static_cast<double>(i)) * (length[i + 1] - length[i]);
  const double angle = 2 * pi * along / length.back();
  const double radius = length.back() / (2 * pi) + half_width - at.v;  // inwards, to keep the orientation
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

AnalyticSurface moebius_strip(double margin) {
  const double high = half_width + margin;
  AnalyticSurface surface;
  surface.at = [](UV at) {
    const double r = 1 + at.v * std::cos(at.u / 2);
    return Point{r * std::cos(at.u), r * std::sin(at.u), at.v * std::sin(at.u / 2)};
  };
  surface.tangents = [](UV at) {
    const double c = std::cos(at.u), s = std::sin(at.u), ch = std::cos(at.u / 2), sh = std::sin(at.u / 2);
    const double r = 1 + at.v * ch, dr = -at.v * sh / 2;
    return Tangents{{dr * c - r * s, dr * s + r * c, at.v * ch / 2}, {ch * c, ch * s, sh}};
  };
  surface.depth = [=](UV at) { return high - std::abs(at.v); };
  surface.across = [](UV at) { return (1 + std::cos(at.u)) / 2; };
  const auto length = std::make_shared<const std::vector<double>>(rim_length(8192));
  surface.plane = [=](UV at) { return annulus(at, *length); };
  surface.in_window = [](UV at) { return std::abs(at.v) > half_width - band; };
  surface.box = {{0, -high}, {2 * pi, high}};
  surface.periodic_u = surface.twisted = true;
  surface.rims = {{straight({4 * pi, high}, {0, high})}};
  return surface;
}

}  // namespace rimline
