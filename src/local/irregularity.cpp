// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/irregularity.h"

#include <algorithm>
#include <cmath>

#include "local/ramp.h"

namespace rimline {
namespace {

// By the quartiles, as of normal numbers.
double deviation_of(std::vector<double>& values) {
  const auto quartile = [&](std::size_t quarters) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(quarters * (values.size() - 1) / 4);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return (quartile(3) - quartile(1)) / 1.349;
}

}  // namespace

double variation_of_nearest(Points points, const Neighbours& neighbours, const std::vector<double>& spacing) {
  double count = 0, sum = 0, squares = 0;
  for (std::size_t i = 0; i < points.size(); i += stride_over(points.size())) {
    const double nearest = distance_to(points, neighbours, static_cast<Index>(i), 0) / spacing[i];
    count += 1;
    sum += nearest;
    squares += nearest * nearest;
  }
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) * count / sum;
}

double irregularity(Points points, const Neighbours& neighbours, const std::vector<double>& spacing) {
  constexpr int far = 11, farthest = 39;
  const auto n = static_cast<std::size_t>(neighbours.size());
  if (neighbours.k <= far + 1) return 0;
  const int last = std::min(farthest, neighbours.k - 1);
  std::vector<double> crowding, reach;
  for (std::size_t i = 0; i < n; i += stride_over(n)) {
    const auto p = static_cast<Index>(i);
    const double twelfth = distance_to(points, neighbours, p, far);
    crowding.push_back(spacing[i] / twelfth);
    reach.push_back(std::log(twelfth / distance_to(points, neighbours, p, last)));
  }
  const auto middle = crowding.begin() + static_cast<std::ptrdiff_t>(crowding.size() / 2);
  std::nth_element(crowding.begin(), middle, crowding.end());
  const double by_nearest = ramp(variation_of_nearest(points, neighbours, spacing), 0.25, 0.3);
  const double by_crowding = ramp(-*middle, -0.55, -0.535);
  // At random areas to the twelfth and the fortieth have a ratio with the law of Beta(12, 28).
  const double at_random = 0.5 * std::sqrt(1 / (far + 0.5) - 1 / (static_cast<double>(last) + 0.5));
  const double by_count = ramp(deviation_of(reach) / at_random, 0.75, 0.85);
  return by_nearest * by_crowding * by_count;
}

}  // namespace rimline
