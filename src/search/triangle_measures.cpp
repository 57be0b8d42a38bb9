// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/triangle_measures.h"

#include <algorithm>
#include <cmath>

#include "base/model.h"
#include "base/vec.h"
#include "local/mean_direction.h"

namespace rimline {
namespace {

TriangleSides measure_sides(const Samples& samples, const Triangle& x) {
  const Points p = samples.points;
  const Point centroid = (1.0 / 3) * (p[x[0]] + p[x[1]] + p[x[2]]);
  TriangleSides sides{0, 1, 0, 1};
  for (const Index v : x) {
    const Point mean = mean_direction(samples, v, model::side_neighbours);
    const double length = norm(mean);
    const double toward = dot(mean, tangent_direction(centroid - p[v], samples.frames[v].normal));
    sides.one_sided += length / 3;
    sides.toward += toward / 3;
    sides.least_one_sided = std::min(sides.least_one_sided, length);
    sides.least_toward = std::min(sides.least_toward, toward);
  }
  return sides;
}

}  // namespace

TriangleMeasures measure_triangle(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                                  Index triangle, const FitnessWeights& weights) {
  const Triangle& x = set.triangle(triangle);
  const Points p = set.points();
  double largest = 0, tip = 0;
  for (int k = 0; k < 3; ++k) {
    const Index before = x[next_in(next_in(k, 3), 3)], v = x[k], after = x[next_in(k, 3)];
    largest = std::max(largest, sizes.own(v));
    tip = std::max(tip, angle_at(p[before], p[v], p[after]));
  }
  return {sizes.log_ratio(x),
          std::clamp(std::log(set.radius(triangle) / largest), model::own_least, model::own_most),
          sizes.spread(x), tip, weights.asks_sides() ? measure_sides(samples, x) : TriangleSides{}};
}

double lack_of_contrast(const TriangleSet& set, const LocalSizes& sizes, Index triangle, int k,
                        const FitnessWeights& weights) {
  const Triangle& x = set.triangle(triangle);
  const Index beside = set.across(triangle, k);
  const double there = std::max(sizes.own(set.apex(beside, x[k], x[next_in(k, 3)])), set.radius(beside));
  return std::clamp(std::log(set.radius(triangle) / there) - weights.least_contrast, -1.0, 0.0);
}

double log_odds_alone(const TriangleMeasures& m, const FitnessWeights& w) {
  return w.open + w.size * m.log_ratio + w.own * m.own + w.spread * m.spread + w.tip * m.tip +
         w.one_sided * m.sides.one_sided + w.least_one_sided * m.sides.least_one_sided +
         w.toward * m.sides.toward + w.least_toward * m.sides.least_toward;
}

}  // namespace rimline
