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
