// SPDX-License-Identifier: GPL-3.0-or-later
// Points and ids: what every stage is given.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

namespace rimline {

// The id of a point: its position in the input, from 0. Signed, so that `none` fits.
using Index = std::int32_t;
inline constexpr Index none = -1;

// A sample point p of P (section 2.1), or a vector between two, in the unit of the input.
struct Point {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_distance(Point a, Point b) { return dot(a - b, a - b); }
inline double distance(Point a, Point b) { return std::sqrt(squared_distance(a, b)); }
inline double norm(Point a) { return std::sqrt(dot(a, a)); }
inline bool is_finite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

// A parameter point: the image of a sample point in the plane.
struct UV {
  double u = 0, v = 0;

  friend constexpr bool operator==(const UV&, const UV&) = default;
};

// Point sets are passed as views: the caller owns the storage.
using Points = std::span<const Point>;

}  // namespace rimline
