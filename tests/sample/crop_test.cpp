// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of a crop against its definition, word for word.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sample/draft.h"

namespace rimline {
namespace {

// Two points of the plane are Delaunay neighbours where some circle through both holds no other point. Its
// centre lies on their bisector, at t; every other point forbids the t on one side.
bool delaunay_neighbours(const std::vector<Point>& points, std::size_t i, std::size_t j) {
  const Point middle = 0.5 * (points[i] + points[j]), d = points[j] - points[i], normal{-d.y, d.x, 0};
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == i || k == j) continue;
    const Point to = points[k] - middle;
    const double side = dot(to, normal), excess = dot(to, to) - dot(d, d) / 4;
    if (side > 0) high = std::min(high, excess / (2 * side));
    if (side < 0) low = std::max(low, excess / (2 * side));
  }
  return low < high;
}

bool holds(const std::vector<Point>& points, const Point& p) {
  return std::find(points.begin(), points.end(), p) != points.end();
}

TEST_CASE("the true boundary of a crop is the points that lost a Delaunay neighbour") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Run run;
    run.seed = seed;
    const double spacing = 0.12;
    const Draft crop = cropped(Shape::FlatDisc, spacing, run, 300);
    AnalyticSurface larger = flat_disc(3 * spacing);
    larger.rims.clear();
    const auto all = blue_noise(larger, {DensityChange::None, spacing}, run, 300).draft.points;
    REQUIRE(all.size() > crop.points.size());

    std::vector<std::uint8_t> on_loop(crop.points.size(), 0);
    for (const auto& loop : crop.loops) {
      for (const Index i : loop) on_loop[i] = 1;
    }
    for (std::size_t i = 0; i < crop.points.size(); ++i) {
      const auto self =
          static_cast<std::size_t>(std::find(all.begin(), all.end(), crop.points[i]) - all.begin());
      REQUIRE(self < all.size());
      bool lost = false;
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (j == self || distance(all[j], all[self]) > 2.5 * spacing || holds(crop.points, all[j])) continue;
        lost = lost || delaunay_neighbours(all, self, j);
      }
      CHECK(lost == (on_loop[i] == 1));
    }
  }
}

TEST_CASE("a crop whose narrow parts would pinch its boundary still has simple loops of Delaunay edges") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Run run;
    run.seed = seed;
    const double spacing = 0.075;  // two rows of points between the holes
    const Draft crop = cropped(Shape::SquareWithHoles, spacing, run, 150);
    std::vector<int> times(crop.points.size(), 0);
    for (const auto& loop : crop.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ++times[loop[i]];
        const double step = distance(crop.points[loop[i]], crop.points[loop[(i + 1) % loop.size()]]);
        CHECK(step < 2 * blue_radius * spacing * 1.01);  // no circle through both is empty otherwise
      }
    }
    CHECK(*std::max_element(times.begin(), times.end()) == 1);
  }
}

TEST_CASE("a crop keeps nearly all points inside and none outside") {
  Run run;
  const double spacing = 0.05;
  const Draft crop = cropped(Shape::FlatDisc, spacing, run, 1300);
  AnalyticSurface larger = flat_disc(3 * spacing);
  larger.rims.clear();
  const auto all = blue_noise(larger, {DensityChange::None, spacing}, run, 1300).draft.points;
  const auto inside = std::count_if(all.begin(), all.end(), [](const Point& p) { return norm(p) < 1; });
  CHECK(std::all_of(crop.points.begin(), crop.points.end(), [](const Point& p) { return norm(p) < 1; }));
  CHECK(crop.points.size() <= inside);
  CHECK(crop.points.size() > 0.98 * static_cast<double>(inside));
}

}  // namespace
}  // namespace rimline
