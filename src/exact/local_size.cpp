// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/local_size.h"

#include <algorithm>
#include <cmath>

namespace rimline::exact {

const LocalSize& LocalSizes::at(Index vertex) {
  LocalSize& size = known_[vertex];
  if (size.median >= 0) return size;
  radii_.clear();
  const auto take = [&](Index v) {
    for (const Index t : complex_.star(v)) radii_.push_back(complex_.radius(t));
  };
  take(vertex);
  for (const Index v : neighbours_.of(vertex, std::min(16, neighbours_.k))) take(v);
  if (radii_.empty()) {
    size.median = neighbours_.distances_of(vertex)[0];
    return size;
  }
  const std::size_t n = radii_.size();
  const auto at = [&](std::size_t rank) { return radii_.begin() + rank; };
  std::nth_element(at(0), at(n / 2), radii_.end());
  std::nth_element(at(0), at(n / 4), at(n / 2));
  std::nth_element(at(n / 2), at(3 * n / 4), radii_.end());
  size.median = *at(n / 2);
  size.spread = (*at(3 * n / 4) - *at(n / 4)) / size.median;
  return size;
}

double LocalSizes::log_ratio(const Triangle& triangle) {
  constexpr double most = 3;
  double median = 0;
  for (const Index v : triangle) median += at(v).median / 3;
  const Points p = complex_.points();
  return std::min(most, std::log(circumradius(p[triangle[0]], p[triangle[1]], p[triangle[2]]) / median));
}

double LocalSizes::own(Index vertex) {
  radii_.clear();
  for (const Index t : complex_.star(vertex)) radii_.push_back(complex_.radius(t));
  const auto middle = radii_.begin() + radii_.size() / 2;
  std::nth_element(radii_.begin(), middle, radii_.end());
  return *middle;
}

double LocalSizes::spread(const Triangle& triangle) {
  double sum = 0;
  for (const Index v : triangle) sum += at(v).spread / 3;
  return sum;
}

}  // namespace rimline::exact
