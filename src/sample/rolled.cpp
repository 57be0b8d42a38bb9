// SPDX-License-Identifier: GPL-3.0-or-later
// Rolled sheets: the chart is the flat sheet, in units of length, so that lengths and angles are its own.
#include <cmath>
#include <numbers>

#include "sample/surface.h"

namespace rimline {
namespace {

using std::numbers::pi;

void set_sheet(AnalyticSurface& surface, const Box& sheet, double margin) {
  surface.box = grown(sheet, margin);
  surface.depth = [box = surface.box](UV at) { return depth_in(box, at); };
  surface.plane = [](UV at) { return at; };
  surface.rims = {around(surface.box)};
}

}  // namespace

// Half of a cylinder about the y axis, open below.
AnalyticSurface half_tunnel(double margin) {
  constexpr double radius = 0.35, length = 1.2;
  AnalyticSurface surface;
  surface.at = [](UV at) {
    const double angle = at.u / radius;
    return Point{-radius * std::cos(angle), at.v, radius * std::sin(angle)};
  };
  surface.tangents = [](UV at) {
    const double angle = at.u / radius;
    return Tangents{{std::sin(angle), 0, std::cos(angle)}, {0, 1, 0}};
  };
  surface.across = [](UV at) { return at.v / length; };
  set_sheet(surface, {{0, 0}, {pi * radius, length}}, margin);
  return surface;
}

// A scroll: a strip rolled one and a half times along a logarithmic spiral about the y axis,
// r = r0 exp(k angle); its arc length has a closed form, s = (r - r0) sqrt(1 + k^2) / k.
AnalyticSurface curled_strip(double margin) {
  constexpr double r0 = 0.3, k = 0.15, width = 0.8;
  static const double slope = k / std::hypot(1, k);
  static const double length = r0 * std::expm1(k * 3 * pi) / slope;
  AnalyticSurface surface;
  surface.at = [](UV at) {
    const double r = r0 + at.u * slope, angle = std::log(r / r0) / k;
    return Point{r * std::cos(angle), at.v, r * std::sin(angle)};
  };
  surface.tangents = [](UV at) {
    const double angle = std::log((r0 + at.u * slope) / r0) / k;
    const double c = std::cos(angle), s = std::sin(angle), turn = slope / k;
    return Tangents{{slope * c - turn * s, 0, slope * s + turn * c}, {0, 1, 0}};
  };
  surface.across = [](UV at) { return at.u / length; };
  set_sheet(surface, {{0, 0}, {length, width}}, margin);
  return surface;
}

// An open cylinder about the z axis. Its lower rim counts as the outer one.
AnalyticSurface pipe(double margin) {
  constexpr double radius = 0.3, length = 1.2;
  const double low = -margin, high = length + margin, girth = 2 * pi * radius;
  AnalyticSurface surface;
  surface.at = [](UV at) {
    const double angle = at.u / radius;
    return Point{radius * std::cos(angle), radius * std::sin(angle), at.v};
  };
  surface.tangents = [](UV at) {
    const double angle = at.u / radius;
    return Tangents{{-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  };
  surface.depth = [=](UV at) { return std::min(at.v - low, high - at.v); };
  surface.across = [](UV at) { return at.v / length; };
  surface.plane = [](UV at) {  // conformal; the lower rim becomes the outer circle
    const double r = std::exp(-at.v / radius), angle = at.u / radius;
    return UV{r * std::cos(angle), r * std::sin(angle)};
  };
  surface.box = {{0, low}, {girth, high}};
  surface.periodic_u = true;
  surface.rims = {{straight({0, low}, {girth, low})}, {straight({girth, high}, {0, high})}};
  return surface;
}

}  // namespace rimline
