// SPDX-License-Identifier: GPL-3.0-or-later
// A torus about the z axis without a cap on its outer equator. Chart: u is the angle about the axis, v the
// length around the tube.
#include <cmath>
#include <numbers>

#include "sample/surface.h"

namespace rimline {
namespace {

using std::numbers::pi;
constexpr double major = 0.65, minor = 0.35;
constexpr double cap = 0.4;  // radius of the cap in the chart; major + minor = 1, so it is nearly round

// Conformal: v is replaced by the integral of dv / (major + minor cos(v / minor)).
UV conformal(UV at) {
  const double root = std::sqrt(major * major - minor * minor);
  const double tangent = std::sqrt((major - minor) / (major + minor)) * std::tan(at.v / (2 * minor));
  return {at.u, 2 * minor / root * std::atan(tangent)};
}

}  // namespace

AnalyticSurface torus_minus_cap(double margin) {
  AnalyticSurface surface;
  surface.at = [](UV at) {
    const double tube = at.v / minor, r = major + minor * std::cos(tube);
    return Point{r * std::cos(at.u), r * std::sin(at.u), minor * std::sin(tube)};
  };
  surface.tangents = [](UV at) {
    const double tube = at.v / minor, r = major + minor * std::cos(tube);
    const double c = std::cos(at.u), s = std::sin(at.u);
    return Tangents{{-r * s, r * c, 0}, {-std::sin(tube) * c, -std::sin(tube) * s, std::cos(tube)}};
  };
  surface.across = [](UV at) { return (1 + (major + minor * std::cos(at.v / minor)) * std::sin(at.u)) / 2; };
  surface.plane = conformal;
  surface.in_window = [](UV at) { return std::hypot(at.u, at.v) < 2.4 * cap; };
  surface.box = {{-pi, -pi * minor}, {pi, pi * minor}};
  surface.periodic_u = true;
  surface.low_end = surface.high_end = End::Periodic;
  surface.rows = Rows::Rings;
  surface.depth = [=](UV at) { return margin > 0 ? 1 : std::hypot(at.u, at.v) - cap; };
  if (margin == 0) surface.rims = {{circle({0, 0}, cap, -1)}};
  return surface;
}

}  // namespace rimline
