// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/local_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/ranks.h"
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

void LocalSizes::find(std::span<const Index> vertices, const Run& run) {
  parallel_slices(vertices.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::vector<double> radii;
    for (const Index v : vertices.subspan(begin, end - begin)) {
      if (known_[v].typical < 0) known_[v] = measure(v, radii);
    }
  });
}

void LocalSizes::find_limits(double margin, const Run& run) {
  if (levels_ && margin == margin_) return;
  margin_ = margin;
  if (!levels_) levels_.emplace(complex_, run);
  limit_.resize(known_.size());
  parallel_for_each(known_.size(), Stage::Loops, run, [&](Index v) { limit_[v] = limit_at(v); });
}

void LocalSizes::drop_limits() {
  levels_.reset();
  limit_ = {};
}

// The logarithm of a mean is at least the mean of logarithms, so a triangle whose radius is at most the
// geometric mean of typical * exp(margin + spread) at its corners is no larger than that.
float LocalSizes::limit_at(Index vertex) const {
  const int near_count = std::min(around, neighbours_.k);
  std::array<Index, around + 1> vertices{vertex};
  std::ranges::copy(neighbours_.of(vertex, near_count), vertices.begin() + 1);
  const StarLevels::Sum sum = levels_->sum({vertices.data(), static_cast<std::size_t>(near_count) + 1});
  if (sum.count == 0 || sum.count > StarLevels::most) return 0;
  const auto [lower, typical, upper] = StarLevels::levels_at(sum, ranks_among(sum.count));
  const double range = std::max(0.0, levels_->least(upper) - levels_->above(lower));  // 0 where none is below
  const double x = margin_ + range / levels_->above(typical);
  const double limit = levels_->least(typical) * (1 + x + x * x / 2 + x * x * x / 6);  // e^x is more
  return static_cast<float>(std::min(limit, double{std::numeric_limits<float>::max()}));
}

bool LocalSizes::may_exceed(Index triangle) const {
  const auto& [a, b, c] = complex_.triangle(triangle);
  constexpr double rounding = 1e-6;
  const double radius = complex_.radius(triangle);
  return (radius / limit_[a]) * (radius / limit_[b]) * (radius / limit_[c]) > 1 - rounding;
}

void LocalSizes::forget(const std::vector<std::uint8_t>& changed, const Run& run) {
  const int near_count = std::min(around, neighbours_.k);
  const auto gone =
      parallel_gather<Index>(known_.size(), Stage::Loops, run, [&](Index v, std::vector<Index>& found) {
        std::uint8_t any = changed[v];
        for (const Index w : neighbours_.of(v, near_count)) any |= changed[w];
        if (any) found.push_back(v);
      });
  for (const Index v : gone) known_[v] = {};
  if (!levels_) return;
  levels_->renew(complex_, changed, run);
  parallel_for_each(gone.size(), Stage::Loops, run, [&](Index i) { limit_[gone[i]] = limit_at(gone[i]); });
}

double LocalSizes::log_ratio(const Triangle& triangle) {
  constexpr double most = 3;
  double typical = 0;
  for (const Index v : triangle) typical += at(v).typical / 3;
  const Points p = complex_.points();
  return std::min(most, std::log(circumradius(p[triangle[0]], p[triangle[1]], p[triangle[2]]) / typical));
}

double LocalSizes::own(Index vertex) const {
  const auto star = complex_.star(vertex);
  std::array<double, 16> few;
  std::vector<double> many(star.size() > few.size() ? star.size() : 0);
  const std::span<double> radii = many.empty() ? std::span(few).first(star.size()) : std::span(many);
  std::ranges::transform(star, radii.begin(), [&](Index t) { return complex_.radius(t); });
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
