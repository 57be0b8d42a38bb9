// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/surface.h"

#include <algorithm>
#include <numbers>

namespace rimline {

Arc straight(UV from, UV to) {
  return [=](double t) { return UV{from.u + t * (to.u - from.u), from.v + t * (to.v - from.v)}; };
}

Arc circle(UV centre, double radius, int turn) {
  return [=](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return UV{centre.u + radius * std::cos(angle), centre.v + turn * radius * std::sin(angle)};
  };
}

Rim around(const Box& box) {
  const UV a = box.low, b{box.high.u, box.low.v}, c = box.high, d{box.low.u, box.high.v};
  return {straight(a, b), straight(b, c), straight(c, d), straight(d, a)};
}

double depth_in(const Box& box, UV at) {
  return std::min({at.u - box.low.u, box.high.u - at.u, at.v - box.low.v, box.high.v - at.v});
}

Box grown(const Box& box, double margin) {
  return {{box.low.u - margin, box.low.v - margin}, {box.high.u + margin, box.high.v + margin}};
}

AnalyticSurface make_surface(Shape shape, double margin) {
  switch (shape) {
    case Shape::FlatDisc: return flat_disc(margin);
    case Shape::BumpySquare: return bumpy_square(margin);
    case Shape::WavySaddle: return wavy_saddle(margin);
    case Shape::HemisphereCap: return hemisphere_cap(margin);
    case Shape::SphereMinusCap: return sphere_minus_cap(margin);
    case Shape::HalfTunnel: return half_tunnel(margin);
    case Shape::CurledStrip: return curled_strip(margin);
    case Shape::Pipe: return pipe(margin);
    case Shape::SquareWithHoles: return square_with_holes(margin);
    case Shape::CappedTube: return capped_tube(margin);
    case Shape::ClosedSphere: return closed_sphere();
    case Shape::TorusMinusCap: return torus_minus_cap(margin);
    case Shape::MoebiusStrip: return moebius_strip(margin);
  }
  throw Error(ErrorCode::BadOption, "there is no such shape");
}

}  // namespace rimline
