// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rims.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "base/random.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

using Edge = std::pair<Index, Index>;

std::vector<Point> random_sheet(int count) {
  Random random(8);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  return points;
}

// The edges of one selected triangle alone: the boundary modulo 2, from the definition.
std::set<Edge> boundary_of(const TriangleSet& set, const Selection& selected) {
  std::map<Edge, int> count;
  for (Index t = 0; t < set.size(); ++t) {
    if (!selected[t]) continue;
    const Triangle& x = set.triangle(t);
    for (int k = 0; k < 3; ++k) ++count[std::minmax(x[k], x[(k + 1) % 3])];
  }
  std::set<Edge> odd;
  for (const auto& [edge, times] : count) {
    if (times % 2 != 0) odd.insert(edge);
  }
  return odd;
}

}  // namespace

TEST_CASE(
    "the boundary of any selection is closed: simple loops through each of its edges once, and no other") {
  const ProposedSurface surface(random_sheet(600));
  Random random(2);
  for (const double share : {0.0, 0.05, 0.3, 0.5, 0.8, 1.0}) {
    Selection selected(surface.set.size(), 0);
    for (auto& s : selected) s = random.uniform() < share;
    std::set<Edge> walked;
    for (const auto& loop : walk_rims(surface.set, selected)) {
      REQUIRE(loop.size() >= 3);
      CHECK(std::set<Index>(loop.begin(), loop.end()).size() == loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i)
        CHECK(walked.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()])).second);
    }
    CHECK(walked == boundary_of(surface.set, selected));
  }
}

TEST_CASE("two triangles that touch in a point have a loop each") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0.2, 0}, {1, -0.2, 0}, {-1, 0.2, 0}, {-1, -0.2, 0}};
  const std::vector<Frame> frames(5, Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  TriangleSet set(points, frames);
  set.add({0, 2, 1});
  set.add({0, 3, 4});
  const auto loops = walk_rims(set, Selection(2, 1));
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].size() == 3);
  CHECK(loops[1].size() == 3);
}
