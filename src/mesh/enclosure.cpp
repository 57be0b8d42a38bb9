// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/enclosure.h"

#include <cmath>
#include <numbers>

namespace rimline {
namespace {

// A loop and its cap, a fan of triangles around its mean.
struct Cap {
  double area = 0;    // the least that any surface over the loop has, seen along its mean normal
  double volume = 0;  // of the cone from `about`, six times; facing out where the surface does
};

Cap cap_over(Points points, const Loop& loop, Point about) {
  Point mean;
  for (const Index v : loop.points)
    mean = mean + (1.0 / static_cast<double>(loop.points.size())) * (points[v] - about);
  Point area;
  Cap cap;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Point a = points[loop.points[i]] - about;
    const Point b = points[loop.points[i + 1 < loop.points.size() ? i + 1 : 0]] - about;
    area = area + 0.5 * cross(a - mean, b - mean);
    cap.volume -= dot(mean, cross(a, b));  // the surface is on the left of the loop, the cap on its right
  }
  cap.area = norm(area);
  return cap;
}

}  // namespace

Side faced_side(Points points, std::span<const Triangle> triangles, const std::vector<Loop>& loops) {
  constexpr double most_open = 0.4, least_round = 0.1;
  if (triangles.empty()) return Side::Unknown;
  const Point about = points[triangles.front()[0]];
  double area = 0, volume = 0, caps = 0;  // the volume six times
  for (const auto& [i, j, k] : triangles) {
    const Point a = points[i] - about, b = points[j] - about, c = points[k] - about;
    area += 0.5 * norm(cross(b - a, c - a));
    volume += dot(a, cross(b, c));
  }
  for (const Loop& loop : loops) {
    const Cap cap = cap_over(points, loop, about);
    caps += cap.area;
    volume += cap.volume;
  }
  if (caps > most_open * area) return Side::Unknown;
  const double whole = area + caps, ball = std::pow(whole, 1.5) / (6 * std::sqrt(std::numbers::pi));
  if (std::abs(volume) / 6 < least_round * ball) return Side::Unknown;
  return volume > 0 ? Side::Outward : Side::Inward;
}

}  // namespace rimline
