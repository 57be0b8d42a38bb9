// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/local_size.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "surface/order_statistics.h"
#include "surface/proposed.h"
#include "surface/star_levels.h"

using namespace rimline;

namespace {

std::vector<Point> random_sheet(int count) {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back({random.uniform(), random.uniform(), 0.01 * random.uniform()});
  return points;
}

// Every value again and again, from the definition.
LocalSize by_sorting(const TriangleSet& set, const Neighbours& neighbours, Index vertex) {
  std::vector<double> radii;
  for (const Index t : set.star(vertex)) radii.push_back(set.radius(t));
  for (const Index v : neighbours.of(vertex, 16)) {
    for (const Index t : set.star(v)) radii.push_back(set.radius(t));
  }
  std::sort(radii.begin(), radii.end());
  const std::size_t n = radii.size();
  return {radii[5 * n / 8], (radii[3 * n / 4] - radii[n / 4]) / radii[5 * n / 8]};
}

int differences(const TriangleSet& set, const Neighbours& neighbours, LocalSizes& sizes) {
  int count = 0;
  for (Index v = 0; v < set.vertices(); ++v) {
    const LocalSize a = sizes.at(v), b = by_sorting(set, neighbours, v);
    count += a.typical != b.typical || a.spread != b.spread;
  }
  return count;
}

}  // namespace

TEST_CASE("values at ranks are those of sorting, for spread out, tied, tiny, huge and infinite values") {
  Random random(1);
  const std::vector<double> odd{0.0, 5e-324, 1e-300, 1, 1, 1, 1e300, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> values(1 + random.below(round % 10 == 0 ? 600 : 120));
    for (double& v : values) {
      v = round % 3 == 0   ? odd[random.below(odd.size())]
          : round % 3 == 1 ? random.uniform()
                           : 1 + 1e-12 * random.uniform();
    }
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = values.size();
    const auto found = at_ranks(values, {n / 4, 5 * n / 8, 3 * n / 4});
    REQUIRE(found[0] == sorted[n / 4]);
    REQUIRE(found[1] == sorted[5 * n / 8]);
    REQUIRE(found[2] == sorted[3 * n / 4]);
  }
}

TEST_CASE("sizes found for all at once, and kept over changes elsewhere, are those of the definition") {
  ProposedSurface surface(random_sheet(3000));
  const auto& [points, neighbours, spacing, frames, set] = surface;
  LocalSizes sizes(set, neighbours);
  std::vector<Index> even;
  for (Index v = 0; v < set.vertices(); v += 2) even.push_back(v);
  sizes.find(even, {});
  CHECK(differences(set, neighbours, sizes) == 0);

  std::vector<std::uint8_t> kept(set.size(), 1), changed(points.size(), 0);
  for (Index t = 0; t < set.size(); t += 97) {
    kept[t] = 0;
    for (const Index v : set.triangle(t)) changed[v] = 1;
  }
  surface.set.keep_only(kept);
  CHECK(differences(set, neighbours, sizes) > 0);
  sizes.forget(changed, {});
  CHECK(differences(set, neighbours, sizes) == 0);
}

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

TEST_CASE("limits never hide a triangle that is larger than usual, and tell most of the others") {
  ProposedSurface surface(random_sheet(3000));
  const auto& [points, neighbours, spacing, frames, set] = surface;
  LocalSizes sizes(set, neighbours);
  for (const double margin : {0.0, 0.1, 0.4}) {
    sizes.find_limits(margin, {});
    int hidden = 0, larger = 0, left = 0;
    for (Index t = 0; t < set.size(); ++t) {
      const bool exceeds = sizes.log_ratio(set.triangle(t)) > margin + sizes.spread(set.triangle(t));
      hidden += exceeds && !sizes.may_exceed(t);
      larger += exceeds;
      left += sizes.may_exceed(t);
    }
    CHECK(hidden == 0);
    CHECK(larger > 20);
    CHECK(left < set.size() / 5 + larger);
  }
}

TEST_CASE("limits follow the triangles that change") {
  ProposedSurface surface(random_sheet(3000));
  const auto& [points, neighbours, spacing, frames, set] = surface;
  LocalSizes sizes(set, neighbours);
  sizes.find_limits(0.1, {});
  // Most of the larger triangles of one half go, so that the others are larger than what is usual there.
  std::vector<std::uint8_t> kept(set.size(), 1), changed(points.size(), 0);
  for (Index t = 0; t < set.size(); ++t) {
    const Triangle& x = set.triangle(t);
    if (points[x[0]].x > 0.5 || set.radius(t) < 0.009 || t % 16 == 0) continue;
    kept[t] = 0;
    for (const Index v : x) changed[v] = 1;
  }
  surface.set.keep_only(kept);
  const auto hidden = [&] {
    LocalSizes fresh(set, neighbours);
    int count = 0;
    for (Index t = 0; t < set.size(); ++t) {
      const Triangle& x = set.triangle(t);
      count += fresh.log_ratio(x) > 0.1 + fresh.spread(x) && !sizes.may_exceed(t);
    }
    return count;
  };
  CHECK(hidden() > 0);
  sizes.forget(changed, {});
  CHECK(hidden() == 0);
  CHECK(differences(set, neighbours, sizes) == 0);
}
