// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/star_levels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "surface/local_size.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

std::vector<Point> random_sheet(int count) {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back({random.uniform(), random.uniform(), 0.01 * random.uniform()});
  return points;
}

}  // namespace

TEST_CASE("levels of stars bracket the radii at ranks, and are fine") {
  ProposedSurface surface(random_sheet(2000));
  const auto& [points, neighbours, spacing, frames, set] = surface;
  const StarLevels levels(set, {});
  double middle_width = 0;
  int middle_count = 0;
  for (const int near : {0, 3, 16, 40}) {
    std::vector<StarLevels::Around> found(points.size());
    levels.look(neighbours, near, 0, found);
    for (Index v = 0; v < set.vertices(); ++v) {
      std::vector<double> sorted;
      for (const Index t : set.star(v)) sorted.push_back(set.radius(t));
      for (const Index w : neighbours.of(v, near)) {
        for (const Index t : set.star(w)) sorted.push_back(set.radius(t));
      }
      std::sort(sorted.begin(), sorted.end());
      const std::size_t n = sorted.size();
      REQUIRE(found[v].known == (n > 0 && n < 255));
      if (!found[v].known) continue;
      const auto ranks = StarLevels::ranks_among(n);
      const std::array level{found[v].lower, found[v].typical, found[v].upper};
      for (int i = 0; i < 3; ++i) {
        REQUIRE(levels.least(level[i]) <= sorted[ranks[i]]);
        REQUIRE(levels.above(level[i]) > sorted[ranks[i]]);
      }
      if (near != 16) continue;
      middle_width += std::log(levels.above(level[1]) / levels.least(level[1]));
      ++middle_count;
    }
  }
  REQUIRE(middle_count > 100);
  CHECK(middle_width / middle_count < 0.1);
}

TEST_CASE("stars of more triangles than a byte can count are not known, and have no limit") {
  // A fan around one point of a large circle, and all others near it.
  constexpr int around = 300;
  std::vector<Point> points{{0, 0, 0}};
  for (int i = 0; i < around; ++i) {
    const double turn = 2 * std::numbers::pi * i / around;
    points.push_back({std::cos(turn), std::sin(turn), 0});
  }
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto frames = fit_frames(points, neighbours, {});
  TriangleSet set(points, frames);
  for (Index i = 0; i < around; ++i) set.add({0, 1 + i, 1 + (i + 1) % around});
  const StarLevels levels(set, {});
  std::array<StarLevels::Around, 2> found;
  levels.look(neighbours, 0, 0, found);
  CHECK(!found[0].known);
  CHECK(found[1].known);
  LocalSizes sizes(set, neighbours);
  sizes.find_limits(0.1, {});
  CHECK(sizes.may_exceed(0));  // its corner in the middle has no limit
}
