// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of revolution about the z axis that end in a pole on top. Chart: u is the angle about the axis, v
// the length along the profile, upwards.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sample/surface.h"

namespace rimline {
namespace {

using std::numbers::pi;

struct Profile {
  double radius, z;    // where
  double dradius, dz;  // which way, as a unit vector
};

AnalyticSurface revolved(const std::function<Profile(double)>& profile, double low, double high) {
  AnalyticSurface surface;
  surface.at = [=](UV at) {
    const Profile p = profile(at.v);
    return Point{p.radius * std::cos(at.u), p.radius * std::sin(at.u), p.z};
  };
  surface.tangents = [=](UV at) {
    const Profile p = profile(at.v);
    const double c = std::cos(at.u), s = std::sin(at.u);
    return Tangents{{-p.radius * s, p.radius * c, 0}, {p.dradius * c, p.dradius * s, p.dz}};
  };
  surface.depth = [=](UV at) { return at.v - low; };
  surface.box = {{0, low}, {2 * pi, high}};
  surface.periodic_u = true;
  surface.high_end = End::Pole;
  surface.rows = Rows::Rings;
  surface.rims = {{straight({0, low}, {2 * pi, low})}};
  return surface;
}

Profile unit_circle(double v) { return {std::cos(v), std::sin(v), -std::sin(v), std::cos(v)}; }

UV polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

// The unit sphere above a latitude.
AnalyticSurface sphere_above(double latitude) {
  AnalyticSurface surface = revolved(unit_circle, std::max(latitude, -pi / 2), pi / 2);
  surface.across = [](UV at) { return (1 + std::cos(at.v) * std::cos(at.u)) / 2; };
  // Stereographic: circles stay circles, so Delaunay here is Delaunay on the sphere.
  surface.plane = [](UV at) { return polar(std::tan((pi / 2 - at.v) / 2), at.u); };
  return surface;
}

}  // namespace

AnalyticSurface hemisphere_cap(double margin) { return sphere_above(-margin); }

// All but a cap of 20 degrees about the south pole.
AnalyticSurface sphere_minus_cap(double margin) { return sphere_above(-70 * pi / 180 - margin); }

AnalyticSurface closed_sphere() {
  AnalyticSurface surface = sphere_above(-pi / 2);
  surface.depth = [](UV) { return 1.0; };
  surface.low_end = End::Pole;
  surface.rims.clear();
  return surface;
}

// A tube that stands on its open end and carries a half sphere.
AnalyticSurface capped_tube(double margin) {
  constexpr double radius = 0.3, length = 0.9, top = length + radius * pi / 2;
  const auto profile = [](double v) -> Profile {
    if (v <= length) return {radius, v, 0, 1};
    const Profile p = unit_circle((v - length) / radius);
    return {radius * p.radius, length + radius * p.z, p.dradius, p.dz};
  };
  AnalyticSurface surface = revolved(profile, -margin, top);
  surface.across = [](UV at) { return at.v / top; };
  surface.plane = [](UV at) {  // conformal on both parts, and they fit
    const double up = (at.v - length) / radius;
    return polar(up <= 0 ? std::exp(-up) : std::tan((pi / 2 - up) / 2), at.u);
  };
  return surface;
}

}  // namespace rimline
