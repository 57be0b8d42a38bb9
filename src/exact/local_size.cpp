// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/local_size.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/ranks.h"
#include "exact/star_levels.h"
#include "parallel.h"

namespace rimline::exact {
namespace {

std::array<std::size_t, 3> ranks_among(std::size_t n) { return {n / 4, 5 * n / 8, 3 * n / 4}; }

}  // namespace

const LocalSize& LocalSizes::at(Index vertex) {
  LocalSize& size = known_[vertex];
  if (size.typical < 0) size = measure(vertex, radii_);
  return size;
}

LocalSize LocalSizes::measure(Index vertex, std::vector<double>& radii) const {
  radii.clear();
  const auto take = [&](Index v) {
    for (const Index t : complex_.star(v)) radii.push_back(complex_.radius(t));
  };
  take(vertex);
  for (const Index v : neighbours_.of(vertex, std::min(around, neighbours_.k))) take(v);
  if (radii.empty()) return {distance_to(complex_.points(), neighbours_, vertex, 0), 0};
  const auto [lower, typical, upper] = at_ranks(radii, ranks_among(radii.size()));
  return {typical, (upper - lower) / typical};
}

void LocalSizes::find(const std::function<bool(Index)>& wanted, const Run& run) {
  parallel_slices(known_.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::vector<double> radii;
    for (Index v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
      if (known_[v].typical < 0 && wanted(v)) known_[v] = measure(v, radii);
    }
  });
}

void LocalSizes::find(std::span<const Index> vertices, const Run& run) {
  parallel_slices(vertices.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::vector<double> radii;
    for (const Index v : vertices.subspan(begin, end - begin)) {
      if (known_[v].typical < 0) known_[v] = measure(v, radii);
    }
  });
}

void LocalSizes::find_bounds(const std::function<bool(Index)>& wanted, const Run& run) {
  const StarLevels levels(complex_, run);
  least_.resize(known_.size());
  parallel_slices(known_.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    StarLevels::Search search(levels);
    std::vector<Index> vertices;
    for (Index v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
      if (least_[v].typical >= 0 || !wanted(v)) continue;
      const auto near = neighbours_.of(v, std::min(around, neighbours_.k));
      vertices.assign(1, v);
      vertices.insert(vertices.end(), near.begin(), near.end());
      const std::size_t n = search.take(vertices);
      if (n == 0) continue;
      const auto [lower, typical, upper] = search.levels_at(ranks_among(n));
      const double spread = (levels.least(upper) - levels.above(lower)) / levels.above(typical);
      least_[v] = {levels.least(typical), std::max(0.0, spread)};
    }
  });
}

bool LocalSizes::may_exceed(Index triangle, double margin) const {
  double typical = 0, spread = 0;
  for (const Index v : complex_.triangle(triangle)) {
    if (least_[v].typical < 0) return true;
    typical += least_[v].typical / 3;
    spread += least_[v].spread / 3;
  }
  constexpr double rounding = 1 - 1e-9;
  const double x = margin + spread;
  return complex_.radius(triangle) > rounding * typical * (1 + x + x * x / 2);  // e^x is more
}

void LocalSizes::forget(const std::vector<std::uint8_t>& changed, const Run& run) {
  parallel_for_each(known_.size(), Stage::Loops, run, [&](Index v) {
    bool near = changed[v];
    for (const Index w : neighbours_.of(v, std::min(around, neighbours_.k))) near |= changed[w] != 0;
    if (!near) return;
    known_[v] = {};
    if (!least_.empty()) least_[v] = {};
  });
}

double LocalSizes::log_ratio(const Triangle& triangle) {
  constexpr double most = 3;
  double typical = 0;
  for (const Index v : triangle) typical += at(v).typical / 3;
  const Points p = complex_.points();
  return std::min(most, std::log(circumradius(p[triangle[0]], p[triangle[1]], p[triangle[2]]) / typical));
}

double LocalSizes::own(Index vertex) const {
  std::vector<double> radii;
  for (const Index t : complex_.star(vertex)) radii.push_back(complex_.radius(t));
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

double LocalSizes::spread(const Triangle& triangle) {
  double sum = 0;
  for (const Index v : triangle) sum += at(v).spread / 3;
  return sum;
}

}  // namespace rimline::exact
