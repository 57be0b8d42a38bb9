// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/selection_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "local/frame.h"
#include "local/star.h"
#include "rimline/neighbours.h"
#include "surface/propose.h"

using namespace rimline;

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
  const TriangleSet set = propose_surface(holed.points, holed.frames, stars, holed.spacing, 4, {});
  LocalSizes sizes(set, holed.neighbours);
  const std::vector<std::uint8_t> excluded(holed.points.size(), mark);
  const SearchResult found =
      SelectionSearch(set, sizes, {holed.points, holed.neighbours, holed.spacing, holed.frames}, excluded, {},
                      {})
          .find({});
  return static_cast<std::size_t>(std::count(found.selected.begin(), found.selected.end(), 0));
}

}  // namespace

TEST_CASE("what is plainly too large is doubted at gaps that are no boundary, too") {
  CHECK(left_out(0) > 0);
  CHECK(left_out(1) > 0);
}

TEST_CASE("a second search takes over what no even rim touches, and finds the rest as the first would") {
  const Holed holed;
  const Stars stars = find_stars(holed.points, holed.neighbours, holed.spacing, holed.frames, {});
  const TriangleSet set = propose_surface(holed.points, holed.frames, stars, holed.spacing, 4, {});
  LocalSizes sizes(set, holed.neighbours);
  const Run run;
  const Samples samples{holed.points, holed.neighbours, holed.spacing, holed.frames};
  const SelectionSearch search(set, sizes, samples, std::vector<std::uint8_t>(holed.points.size(), 0), {},
                               run);
  const Selection found = search.find({}).selected;
  const std::vector<double> uneven(holed.points.size(), 0), even(holed.points.size(), 1);
  Selection other = found;
  std::size_t turned = 0;
  for (Index t = 0; t < set.size(); ++t) {
    if (found[t]) continue;
    other[t] = 1;
    ++turned;
  }
  REQUIRE(turned > 0);
  CHECK(search.find_again(uneven, other).selected == other);
  CHECK(search.find_again(even, other).selected == search.find(even).selected);
  CHECK(search.find(uneven).selected == found);
}
