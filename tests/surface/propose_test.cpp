// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/propose.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "surface/proposed.h"
#include "surface/rims.h"

using namespace rimline;

namespace {

std::vector<Point> grid(int side) {
  std::vector<Point> points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) points.push_back({double(x), double(y), 0});
  }
  return points;
}

double area_of(const TriangleSet& set) {
  double sum = 0;
  for (Index t = 0; t < set.size(); ++t) {
    const Triangle& x = set.triangle(t);
    const Points p = set.points();
    sum += norm(cross(p[x[1]] - p[x[0]], p[x[2]] - p[x[0]])) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("a grid, all of whose cells are ties, is covered once, with one rim") {
  const ProposedSurface surface(grid(15));
  CHECK(surface.set.size() == 2 * 14 * 14);
  CHECK(area_of(surface.set) == doctest::Approx(14 * 14));
  CHECK(walk_rims(surface.set, Selection(surface.set.size(), 1)).size() == 1);
}

TEST_CASE("what is proposed has no larger triangle than asked for, and at most two at an edge") {
  Random random(6);
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  const ProposedSurface surface(points);
  const TriangleSet& set = surface.set;
  for (Index t = 0; t < set.size(); ++t) {
    const Triangle& x = set.triangle(t);
    const double largest = std::max({surface.spacing[x[0]], surface.spacing[x[1]], surface.spacing[x[2]]});
    CHECK(set.radius(t) <= 3 * largest);
    for (int k = 0; k < 3; ++k) {
      Index found[2];
      int count = 0;
      for (const Index other : set.star(x[k])) {
        const Triangle& y = set.triangle(other);
        count += std::count(y.begin(), y.end(), x[(k + 1) % 3]) == 1;
      }
      CHECK(count == set.edge(x[k], x[(k + 1) % 3], found));
      CHECK(count <= 2);
    }
  }
}

TEST_CASE("missing ears are filled up to the size, the smallest first, and no others") {
  ProposedSurface surface(grid(15));
  TriangleSet& set = surface.set;
  // An ear of the grid's rim goes: the triangle at an edge of the lowest row.
  Index found[2];
  REQUIRE(set.edge(7, 8, found) == 1);
  const double area = area_of(set);
  Selection kept(set.size(), 1);
  kept[found[0]] = 0;
  set.keep_only(kept);
  REQUIRE(area_of(set) == doctest::Approx(area - 0.5));
  CHECK(area_of(with_missing_ears(set, surface.spacing, 0.1, {})) == doctest::Approx(area - 0.5));
  CHECK(area_of(with_missing_ears(set, surface.spacing, 1, {})) == doctest::Approx(area));
}
