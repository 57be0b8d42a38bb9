// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/open_ears.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

ProposedSurface strewn() {
  Random random(5);
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  return ProposedSurface(points);
}

std::vector<std::uint8_t> points_on_rims(const TriangleSet& set) {
  std::vector<std::uint8_t> on_rim(set.vertices(), 0);
  for (Index t = 0; t < set.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (set.across(t, k) != none) continue;
      on_rim[set.triangle(t)[k]] = on_rim[set.triangle(t)[(k + 1) % 3]] = 1;
    }
  }
  return on_rim;
}

// Of a triangle of the whole surface: one side of it is open and its apex is inside, or two are open and end
// a point that no other triangle has.
bool is_plainly_an_ear(const TriangleSet& set, const std::vector<std::uint8_t>& on_rim, Index t) {
  int open = 0, last = 0, closed = 0;
  for (int k = 0; k < 3; ++k) {
    if (set.across(t, k) == none) {
      ++open;
      last = k;
    } else {
      closed = k;
    }
  }
  const Triangle& x = set.triangle(t);
  if (open == 1) return on_rim[x[(last + 2) % 3]] == 0;
  return open == 2 && set.star(x[(closed + 2) % 3]).size() == 1;
}

}  // namespace

TEST_CASE("a triangle is opened as an ear where that leaves the number of rims and of their meetings") {
  const ProposedSurface surface = strewn();
  const TriangleSet& set = surface.set;
  const Selection all(set.size(), 1);
  const auto on_rim = points_on_rims(set);
  int ears = 0;
  for (Index t = 0; t < set.size(); ++t) {
    Selection without = all;
    without[t] = 0;
    const bool is_ear = is_plainly_an_ear(set, on_rim, t);
    CHECK(open_ears(set, all, without, 1, {}) == (is_ear ? without : all));
    CHECK(open_ears(set, without, all, 1, {}) == without);  // what closes is not taken over
    ears += is_ear;
  }
  CHECK(ears > 10);
}

TEST_CASE("what is opened is as long as it may be at most, whichever corners it hangs together over") {
  const ProposedSurface surface = strewn();
  const TriangleSet& set = surface.set;
  const Selection all(set.size(), 1);
  const auto on_rim = points_on_rims(set);
  std::vector<Index> two;  // ears that share a point of the rim
  for (Index t = 0; t < set.size() && two.size() < 2; ++t) {
    if (!is_plainly_an_ear(set, on_rim, t)) continue;
    for (const Index v : set.triangle(t)) {
      for (const Index other : set.star(v)) {
        Selection without = all;
        without[t] = without[other] = 0;
        if (other > t && two.empty() && open_ears(set, all, without, 2, {}) == without) two = {t, other};
      }
    }
  }
  REQUIRE(two.size() == 2);
  Selection without = all;
  without[two[0]] = without[two[1]] = 0;
  CHECK(open_ears(set, all, without, 1, {}) == all);
  without = all;
  without[two[0]] = 0;
  CHECK(open_ears(set, all, without, 1, {}) == without);
}

TEST_CASE("a run that would join two rims is not opened") {
  // A strip two points wide around a large hole: two triangles lead from one rim to the other.
  std::vector<Point> points;
  for (int i = 0; i < 64; ++i) {
    const double angle = i * 0.09817477042468103;  // a 64th of a turn
    for (const double radius : {9.7, 10.7})
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  const ProposedSurface surface(points);
  const TriangleSet& set = surface.set;
  const Selection all(set.size(), 1);
  int tried = 0;
  for (Index t = 0; t < set.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Index beside = set.across(t, k);
      if (beside == none || !set.is_at_rim(t) || !set.is_at_rim(beside)) continue;
      Selection without = all;
      without[t] = without[beside] = 0;
      CHECK(open_ears(set, all, without, 2, {}) == all);
      ++tried;
    }
  }
  CHECK(tried > 20);
}
