// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/rim.h"

#include <algorithm>
#include <cmath>

namespace rimline {
namespace {

// Length in spacings from the arc's start to t = i / steps, for all i.
std::vector<double> running_length(const Arc& arc, const StepLength& length, int steps) {
  std::vector<double> running(steps + 1, 0);
  UV before = arc(0);
  for (int i = 1; i <= steps; ++i) {
    const UV here = arc(static_cast<double>(i) / steps);
    running[i] = running[i - 1] + length(before, here);
    before = here;
  }
  return running;
}

// Fine enough to be straight between two entries: eight to a spacing or more.
std::vector<double> length_table(const Arc& arc, const StepLength& length) {
  constexpr int coarse = 1024;
  auto table = running_length(arc, length, coarse);
  if (8 * table.back() > coarse) table = running_length(arc, length, static_cast<int>(8 * table.back()));
  return table;
}

// Where the running length is `target`, as t.
double place_at(const std::vector<double>& running, double target) {
  const auto above = std::upper_bound(running.begin() + 1, running.end() - 1, target);
  const auto i = static_cast<double>(above - running.begin() - 1);
  const double low = *(above - 1), high = *above;
  const double part = high > low ? (target - low) / (high - low) : 0;
  return std::clamp((i + part) / static_cast<double>(running.size() - 1), 0.0, 1.0);
}

// The arc's start and the points after it; its end belongs to the next arc.
void walk_arc(const Arc& arc, const StepLength& length, double step, int fewest, std::vector<UV>& points) {
  const auto running = length_table(arc, length);
  const int steps = std::max(fewest, static_cast<int>(std::lround(running.back() / step)));
  for (int i = 0; i < steps; ++i)
    points.push_back(arc(i == 0 ? 0 : place_at(running, running.back() * i / steps)));
}

}  // namespace

std::vector<std::vector<UV>> walk_rims(const AnalyticSurface& surface, const StepLength& length,
                                       double step) {
  std::vector<std::vector<UV>> rims;
  for (const Rim& rim : surface.rims) {
    auto& points = rims.emplace_back();
    for (const Arc& arc : rim) walk_arc(arc, length, step, rim.size() == 1 ? 3 : 1, points);
  }
  return rims;
}

RimDistance::RimDistance(const AnalyticSurface& surface, const StepLength& length, double reach,
                         std::function<Point(UV)> place)
    : place_(std::move(place)), curve_(reach, 0) {
  const auto rims = walk_rims(surface, length, 1.0 / 8);
  std::size_t count = 0;
  for (const auto& rim : rims) count += rim.size();
  curve_ = PointGrid(reach, count);
  for (const auto& rim : rims) {
    for (const UV at : rim) curve_.insert(place_(at));
  }
}

bool RimDistance::within_half(UV at, double along, double across, const Point& direction) const {
  const Point p = place_(at);
  bool found = false;
  curve_.near(p, std::max(along, across) / 2, [&](Index i) {
    const Point d = curve_.points()[i] - p;
    const double a = dot(d, direction);
    const double b2 = std::max(0.0, dot(d, d) - a * a);
    found = found || a * a / (along * along) + b2 / (across * across) < 0.25;
  });
  return found;
}

}  // namespace rimline
