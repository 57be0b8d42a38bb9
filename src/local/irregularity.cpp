// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/irregularity.h"

#include <algorithm>
#include <cmath>

#include "base/model.h"
#include "local/ramp.h"

namespace rimline {
namespace {

int last_rank(int k) { return std::min(model::irregular_far, k - 1); }

// By the quartiles, as of normal numbers.
double deviation_of(std::vector<double>& values) {
  const auto quartile = [&](std::size_t quarters) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(quarters * (values.size() - 1) / 4);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return (quartile(3) - quartile(1)) / 1.349;  // [layout] of a normal law
}

}  // namespace

Distances measure_distances(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                            Index point) {
  Distances d;
  d.nearest = distance_to(points, neighbours, point, 0) / spacing[point];
  if (neighbours.k <= model::irregular_near + 1) return d;
  const double twelfth = distance_to(points, neighbours, point, model::irregular_near);
  d.crowding = spacing[point] / twelfth;
  d.reach = std::log(twelfth / distance_to(points, neighbours, point, last_rank(neighbours.k)));
  return d;
}

double variation_of_nearest(const std::vector<Distances>& distances) {
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(distances.size());
  for (const Distances& d : distances) {
    sum += d.nearest;
    squares += d.nearest * d.nearest;
  }
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) * count / sum;
}

double irregularity(const std::vector<Distances>& distances, int k) {
  if (k <= model::irregular_near + 1) return 0;
  std::vector<double> crowding, reach;
  for (const Distances& d : distances) {
    crowding.push_back(d.crowding);
    reach.push_back(d.reach);
  }
  const auto middle = crowding.begin() + static_cast<std::ptrdiff_t>(crowding.size() / 2);
  std::nth_element(crowding.begin(), middle, crowding.end());
  const double by_nearest =
      ramp(variation_of_nearest(distances), model::variation_even, model::variation_random);
  const double by_crowding = ramp(-*middle, -model::crowding_even, -model::crowding_random);
  // For random points the ratio of the areas to the twelfth and to the fortieth neighbour has the
  // distribution Beta(12, 28).
  const double at_random =
      0.5 * std::sqrt(1 / (model::irregular_near + 0.5) - 1 / (static_cast<double>(last_rank(k)) + 0.5));
  const double by_count = ramp(deviation_of(reach) / at_random, model::counts_even, model::counts_random);
  return by_nearest * by_crowding * by_count;
}

}  // namespace rimline
