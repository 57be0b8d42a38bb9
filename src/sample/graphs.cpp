// SPDX-License-Identifier: GPL-3.0-or-later
// Height fields z(x, y): the chart is (x, y) itself.
#include <algorithm>
#include <cmath>
#include <functional>

#include "sample/surface.h"

namespace rimline {
namespace {

struct Height {
  double z, dx, dy;
};

AnalyticSurface graph(const std::function<Height(UV)>& height) {
  AnalyticSurface surface;
  surface.at = [=](UV at) { return Point{at.u, at.v, height(at).z}; };
  surface.tangents = [=](UV at) {
    const Height h = height(at);
    return Tangents{{1, 0, h.dx}, {0, 1, h.dy}};
  };
  surface.plane = [](UV at) { return at; };
  return surface;
}

Height flat(UV) { return {0, 0, 0}; }

// Bumps and pits 0.16 from top to bottom, a third of the side apart; slopes reach 0.75.
Height bumps(UV at) {
  constexpr double a = 0.08, k = 9.42;
  const double x = k * at.u + 0.5, y = k * at.v + 1.1;
  return {a * std::sin(x) * std::sin(y), a * k * std::cos(x) * std::sin(y),
          a * k * std::sin(x) * std::cos(y)};
}

Height saddle(UV at) {
  constexpr double bend = 0.3, a = 0.03, k = 5;
  const double ripple = std::sin(k * at.u) * std::cos(k * at.v);
  return {bend * (at.u * at.u - at.v * at.v) + a * ripple,
          2 * bend * at.u + a * k * std::cos(k * at.u) * std::cos(k * at.v),
          -2 * bend * at.v - a * k * std::sin(k * at.u) * std::sin(k * at.v)};
}

// The outline of the saddle: a flower of five leaves, so that the boundary is convex and concave by turns.
constexpr double leaf = 0.12;
double flower(double angle) { return 1 + leaf * std::cos(5 * angle); }

void set_square(AnalyticSurface& surface, double side, double margin) {
  const Box box = grown({{0, 0}, {side, side}}, margin);
  surface.box = box;
  surface.depth = [=](UV at) { return depth_in(box, at); };
  surface.across = [=](UV at) { return at.u / side; };
  surface.rims = {around(box)};
}

}  // namespace

AnalyticSurface flat_disc(double margin) {
  AnalyticSurface surface = graph(flat);
  const double radius = 1 + margin;
  surface.box = {{-radius, -radius}, {radius, radius}};
  surface.depth = [=](UV at) { return radius - std::hypot(at.u, at.v); };
  surface.across = [](UV at) { return (1 + at.u) / 2; };
  surface.rims = {{circle({0, 0}, radius, 1)}};
  return surface;
}

AnalyticSurface bumpy_square(double margin) {
  AnalyticSurface surface = graph(bumps);
  set_square(surface, 1, margin);
  return surface;
}

AnalyticSurface wavy_saddle(double margin) {
  AnalyticSurface surface = graph(saddle);
  const double radius = 1 + leaf + margin;
  surface.box = {{-radius, -radius}, {radius, radius}};
  surface.depth = [=](UV at) {
    const double steepest = std::hypot(1, 5 * leaf / (1 - leaf));  // of the outline's radius, outside it
    return (flower(std::atan2(at.v, at.u)) + margin - std::hypot(at.u, at.v)) / steepest;
  };
  surface.across = [](UV at) { return (1 + leaf + at.u) / (2 * (1 + leaf)); };
  surface.rims = {{[=](double t) {
    const UV direction = circle({0, 0}, 1, 1)(t);
    const double r = flower(std::atan2(direction.v, direction.u)) + margin;
    return UV{r * direction.u, r * direction.v};
  }}};
  return surface;
}

AnalyticSurface square_with_holes(double margin) {
  struct Hole {
    UV centre;
    double radius;
  };
  constexpr Hole holes[] = {{{0.27, 0.27}, 0.13}, {{0.69, 0.40}, 0.16}, {{0.38, 0.75}, 0.12}};

  AnalyticSurface surface = graph(flat);
  set_square(surface, 1, margin);
  if (margin > 0) return surface;
  surface.depth = [=, box = surface.box](UV at) {
    double depth = depth_in(box, at);
    for (const Hole& hole : holes) {
      depth = std::min(depth, std::hypot(at.u - hole.centre.u, at.v - hole.centre.v) - hole.radius);
    }
    return depth;
  };
  for (const Hole& hole : holes) surface.rims.push_back({circle(hole.centre, hole.radius, -1)});
  return surface;
}

}  // namespace rimline
