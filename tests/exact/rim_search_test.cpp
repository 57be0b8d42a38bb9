// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/frame.h"
#include "exact/propose.h"
#include "exact/star.h"
#include "rimline/neighbours.h"

using namespace rimline;
using namespace rimline::exact;

namespace {

// A lattice of unit step with a round hole, which triangles of up to four spacings close.
struct Holed {
  static constexpr double radius = 2.8;
  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<double> spacing;
  std::vector<Frame> frames;

  Holed() {
    for (int y = -10; y <= 10; ++y) {
      for (int x = -10; x <= 10; ++x) {
        if (std::hypot(x, y) >= radius) points.push_back({double(x), double(y), 0});
      }
    }
    neighbours = find_neighbours(points, 40, {});
    spacing = local_spacing(points, neighbours);
    frames = fit_frames(points, neighbours, {});
  }
};

// Triangles that are left out where all points are marked.
std::size_t left_out(std::uint8_t mark) {
  const Holed holed;
  const Stars stars = find_stars(holed.points, holed.neighbours, holed.spacing, holed.frames, {});
  const Complex complex = propose_surface(holed.points, holed.frames, stars, holed.spacing, 4, {});
  LocalSizes sizes(complex, holed.neighbours);
  const std::vector<std::uint8_t> barred(holed.points.size(), mark);
  const RimSearchResult found = RimSearch(complex, sizes, barred, {}, {}).find({});
  return static_cast<std::size_t>(std::count(found.kept.begin(), found.kept.end(), 0));
}

}  // namespace

TEST_CASE("what is plainly too large is doubted at gaps that are no boundary, too") {
  CHECK(left_out(0) > 0);
  CHECK(left_out(1) > 0);
}

TEST_CASE("a second search takes over what no even rim touches, and finds the rest as the first would") {
  const Holed holed;
  const Stars stars = find_stars(holed.points, holed.neighbours, holed.spacing, holed.frames, {});
  const Complex complex = propose_surface(holed.points, holed.frames, stars, holed.spacing, 4, {});
  LocalSizes sizes(complex, holed.neighbours);
  const Run run;
  const RimSearch search(complex, sizes, std::vector<std::uint8_t>(holed.points.size(), 0), {}, run);
  const Kept found = search.find({}).kept;
  const std::vector<double> uneven(holed.points.size(), 0), even(holed.points.size(), 1);
  Kept other = found;
  std::size_t turned = 0;
  for (Index t = 0; t < complex.size(); ++t) {
    if (found[t]) continue;
    other[t] = 1;
    ++turned;
  }
  REQUIRE(turned > 0);
  CHECK(search.find_again(uneven, other).kept == other);
  CHECK(search.find_again(even, other).kept == search.find(even).kept);
  CHECK(search.find(uneven).kept == found);
}
