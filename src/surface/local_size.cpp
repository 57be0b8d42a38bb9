// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/local_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "surface/order_statistics.h"

namespace rimline {
namespace {

constexpr float not_known = std::numeric_limits<float>::infinity();  // which all radii exceed

}  // namespace

const LocalSize& LocalSizes::at(Index vertex) const {
  LocalSize& size = known_[vertex];
  if (size.typical < 0) size = measure(vertex, radii_);
  return size;
}

LocalSize LocalSizes::measure(Index vertex, std::vector<double>& radii) const {
  radii.clear();
  const auto take = [&](Index v) {
    for (const Index t : set_.star(v)) radii.push_back(set_.radius(t));
  };
  take(vertex);
  for (const Index v : neighbours_.of(vertex, std::min(around, neighbours_.k))) take(v);
  if (radii.empty()) return {distance_to(set_.points(), neighbours_, vertex, 0), 0};
  const auto [lower, typical, upper] = at_ranks(radii, StarLevels::ranks_among(radii.size()));
  return {typical, (upper - lower) / typical};
}

void LocalSizes::find(std::span<const Index> vertices, const Run& run) const {
  parallel_slices(vertices.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::vector<double> radii;
    for (const Index v : vertices.subspan(begin, end - begin)) {
      if (known_[v].typical < 0) known_[v] = measure(v, radii);
    }
  });
}

void LocalSizes::find_limits(double margin, const Run& run) const {
  if (levels_ && margin == margin_) return;
  margin_ = margin;
  if (!levels_) levels_.emplace(set_, run);
  inverse_limit_.resize(known_.size());
  parallel_slices(known_.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    bound(static_cast<Index>(begin), static_cast<Index>(end));
  });
}

// The logarithm of a mean is at least the mean of logarithms, so a triangle whose radius is at most the
// geometric mean of typical * exp(margin + spread) at its corners is no larger than that.
void LocalSizes::bound(Index begin, Index end) const {
  constexpr double sixth = 1.0 / 6, most = 1e30;  // whose inverse is no tiny number yet [layout]
  const StarLevels& levels = *levels_;
  std::array<StarLevels::Around, 256> found;  // [speed]
  while (begin < end) {
    const auto here = std::span(found).first(std::min<std::size_t>(found.size(), end - begin));
    levels.look(neighbours_, std::min(around, neighbours_.k), begin, here);
    for (const auto& [lower, typical, upper, known] : here) {
      const double range = std::max(0.0, levels.least(upper) - levels.above(lower));
      const double x = margin_ + range / levels.above(typical);  // the spread is no less
      const double limit = levels.least(typical) * (1 + x + x * x * (0.5 + x * sixth));  // e^x is more
      inverse_limit_[begin++] = known ? static_cast<float>(1 / std::min(limit, most)) : not_known;
    }
  }
}

bool LocalSizes::may_exceed(Index triangle) const {
  const auto& [a, b, c] = set_.triangle(triangle);
  constexpr double rounding = 1e-6;  // [guard]
  const double radius = set_.radius(triangle);
  return (radius * inverse_limit_[a]) * (radius * inverse_limit_[b]) * (radius * inverse_limit_[c]) >
         1 - rounding;
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
  levels_->renew(set_, changed, run);
  parallel_for_each(gone.size(), Stage::Loops, run, [&](Index i) { bound(gone[i], gone[i] + 1); });
}

double LocalSizes::log_ratio(const Triangle& triangle) const {
  constexpr double most = 3;
  double typical = 0;
  for (const Index v : triangle) typical += at(v).typical / 3;
  const Points p = set_.points();
  return std::min(most, std::log(circumradius(p[triangle[0]], p[triangle[1]], p[triangle[2]]) / typical));
}

double LocalSizes::own(Index vertex) const {
  const auto star = set_.star(vertex);
  std::array<double, 16> few;  // [speed]
  std::vector<double> many(star.size() > few.size() ? star.size() : 0);
  const std::span<double> radii = many.empty() ? std::span(few).first(star.size()) : std::span(many);
  std::ranges::transform(star, radii.begin(), [&](Index t) { return set_.radius(t); });
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

double LocalSizes::spread(const Triangle& triangle) const {
  double sum = 0;
  for (const Index v : triangle) sum += at(v).spread / 3;
  return sum;
}

}  // namespace rimline
