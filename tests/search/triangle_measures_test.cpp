// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/triangle_measures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "surface/proposed.h"

using namespace rimline;

namespace {

// Triangles of a lattice, equilateral but for rounding.
std::vector<Point> lattice() {
  std::vector<Point> points;
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 15; ++x) points.push_back({x + 0.5 * y, std::sqrt(0.75) * y, 0});
  }
  return points;
}

}  // namespace

TEST_CASE("a triangle of a lattice has a third of a half turn as its widest angle, and a usual size") {
  const ProposedSurface surface(lattice());
  const LocalSizes sizes(surface.set, surface.neighbours);
  const Samples samples{surface.points, surface.neighbours, surface.spacing, surface.frames};
  for (Index t = 0; t < surface.set.size(); ++t) {
    const TriangleMeasures m = measure_triangle(surface.set, sizes, samples, t, {});
    if (surface.set.radius(t) > 0.6) continue;  // at the outline
    CHECK(m.tip == doctest::Approx(std::numbers::pi / 3).epsilon(1e-6));
    CHECK(m.log_ratio == doctest::Approx(0).epsilon(0.01));
  }
}

TEST_CASE("the log odds of a triangle are the sum of its measures, each by its weight") {
  FitnessWeights w;
  w.open = 1;
  w.size = 2;
  w.own = 3;
  w.spread = 5;
  w.tip = 7;
  w.one_sided = 11;
  w.least_one_sided = 13;
  w.toward = 17;
  w.least_toward = 19;
  CHECK(log_odds_alone({1, 0, 0, 0, {}}, w) == 3);
  CHECK(log_odds_alone({0, 1, 0, 0, {}}, w) == 4);
  CHECK(log_odds_alone({0, 0, 1, 0, {}}, w) == 6);
  CHECK(log_odds_alone({0, 0, 0, 1, {}}, w) == 8);
  CHECK(log_odds_alone({0, 0, 0, 0, {1, 0, 0, 0}}, w) == 12);
  CHECK(log_odds_alone({0, 0, 0, 0, {0, 1, 0, 0}}, w) == 14);
  CHECK(log_odds_alone({0, 0, 0, 0, {0, 0, 1, 0}}, w) == 18);
  CHECK(log_odds_alone({0, 0, 0, 0, {0, 0, 0, 1}}, w) == 20);
}

TEST_CASE("the first searches do not ask for angles, the one along rims does") {
  const FitnessWeights first;
  CHECK(first.tip == 0);
  CHECK(!first.asks_sides());
  const FitnessWeights rims = weights_along_rims(first);
  CHECK(rims.tip > 0);
  CHECK(rims.asks_sides());
  CHECK(rims.hole_prior == first.hole_prior);
  CHECK(rims.isolated == first.isolated);
}

TEST_CASE("neighbours are all around inside, and on one side of the outline, away from what lies beyond it") {
  // Half a plane with a notch, whose sides rise by half a right angle from (0, -10).
  std::vector<Point> points;
  for (int y = -30; y <= 0; ++y) {
    for (int x = -30; x <= 30; ++x) {
      if (y <= std::abs(x) - 10) points.push_back({x + 0.001 * y, 1.0 * y, 0});
    }
  }
  const ProposedSurface surface(points);
  const Samples samples{surface.points, surface.neighbours, surface.spacing, surface.frames};
  const LocalSizes sizes(surface.set, surface.neighbours);
  const FitnessWeights weights = weights_along_rims({});
  const auto has = [&](const Triangle& x, int column, int row) {
    return std::any_of(x.begin(), x.end(), [&](Index v) {
      return std::abs(surface.points[v].x - column) < 0.1 && surface.points[v].y == row;
    });
  };
  int beyond = 0, inside = 0, along = 0;
  for (Index t = 0; t < surface.set.size(); ++t) {
    const Triangle& x = surface.set.triangle(t);
    const TriangleSides s = measure_triangle(surface.set, sizes, samples, t, weights).sides;
    if (has(x, 0, -10) && has(x, -1, -9) && has(x, 1, -9)) {
      ++beyond;
      CHECK(s.toward < -0.05);
      CHECK(s.least_one_sided > 0.2);
    }
    if (has(x, 0, -20)) {
      ++inside;
      CHECK(s.one_sided < 0.1);
      CHECK(std::abs(s.toward) < 0.1);
    }
    if (has(x, 20, 0) && has(x, 21, 0)) {
      ++along;
      CHECK(s.toward > 0.1);  // two corners of it look across it
      CHECK(s.one_sided > 0.4);
    }
  }
  CHECK(beyond == 1);
  CHECK(inside >= 4);
  CHECK(along == 1);
}
