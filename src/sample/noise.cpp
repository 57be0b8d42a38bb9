// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/noise.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/random.h"
#include "rimline/neighbours.h"

namespace rimline {
namespace {

// Two independent standard normal numbers (Box and Muller 1958): std:: distributions differ between
// libraries.
std::pair<double, double> normal_pair(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  const double angle = 2 * std::numbers::pi * random.uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

std::vector<double> local_nearest_distance(Points points, const Run& run) {
  const Neighbours neighbours = find_neighbours(points, 8, run);
  std::vector<double> mean(points.size());
  for (Index i = 0; i < neighbours.size(); ++i) {
    double sum = distance_to(points, neighbours, i, 0);
    for (const Index j : neighbours.of(i)) sum += distance_to(points, neighbours, j, 0);
    mean[i] = sum / (1 + neighbours.k);
  }
  return mean;
}

void add_noise(std::vector<Point>& points, double deviation, const Run& run) {
  if (deviation == 0) return;
  const auto distance = local_nearest_distance(points, run);
  Random random(run.seed, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = normal_pair(random);
    const double z = normal_pair(random).first;
    points[i] = points[i] + deviation * distance[i] * Point{x, y, z};
  }
}

}  // namespace rimline
