// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/components.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/random.h"

using namespace rimline;

namespace {

// Strips of `columns` by `rows` squares, each of two triangles that lie either way, the second strip first. A
// strip's ends may be joined, with or without half a twist.
struct Strips {
  std::vector<Point> points;
  std::vector<Frame> frames;
  std::vector<Triangle> triangles;

  void add(int columns, int rows, bool joined, bool twisted, double z) {
    const Index first = static_cast<Index>(points.size());
    for (int i = 0; i <= columns - joined; ++i) {
      const double turn = 2 * std::numbers::pi * i / columns, tilt = twisted ? turn / 2 : 0;
      for (int j = 0; j <= rows; ++j) {
        const double off = 0.2 * (j - 0.5 * rows) / rows;
        const Point bent{(1 + off * std::cos(tilt)) * std::cos(turn),
                         (1 + off * std::cos(tilt)) * std::sin(turn), z + off * std::sin(tilt)};
        points.push_back(joined ? bent : Point{static_cast<double>(i), static_cast<double>(j), z});
      }
    }
    const auto at = [&](int i, int j) {
      const bool around = joined && i == columns;
      return first + (around ? 0 : i) * (rows + 1) + (around && twisted ? rows - j : j);
    };
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  void turn_some() {
    Random random(5);
    for (Triangle& t : triangles) {
      if (random.below(2)) std::swap(t[1], t[2]);
    }
  }
  TriangleSet set() {
    frames.resize(points.size());
    TriangleSet set(points, frames);
    for (const Triangle& t : triangles) set.add(t);
    return set;
  }
};

// Pairs of triangles at an edge that both run through it the same way.
int disagreements(const TriangleSet& set, const Selection& selected) {
  int count = 0;
  for (Index t = 0; t < set.size(); ++t) {
    if (!selected[t]) continue;
    for (int k = 0; k < 3; ++k) {
      const Index a = set.triangle(t)[k], b = set.triangle(t)[(k + 1) % 3], other = set.across(t, k);
      if (other == none || !selected[other] || other < t) continue;
      for (int i = 0; i < 3; ++i) {
        count += set.triangle(other)[i] == a && set.triangle(other)[(i + 1) % 3] == b;
      }
    }
  }
  return count;
}

double signed_area_up(const TriangleSet& set, Index t) {
  const Points p = set.points();
  const Triangle& x = set.triangle(t);
  return cross(p[x[1]] - p[x[0]], p[x[2]] - p[x[0]]).z;
}

}  // namespace

TEST_CASE(
    "components of many blocks of triangles all face up, whichever way the triangles lay, on any threads") {
  Strips strips;
  strips.add(150, 90, false, false, 0);
  strips.add(40, 200, false, false, 7);
  strips.turn_some();
  for (const int threads : {1, 2}) {
    TriangleSet set = strips.set();
    Run run;
    run.threads = threads;
    const Selection selected(set.size(), 1);
    const Components components = find_components(set, selected, run);
    set = turn_over(std::move(set), components.turned);
    REQUIRE(components.count() == 2);
    CHECK((components.orientable[0] && components.orientable[1]));
    int wrong = 0;
    for (Index t = 0; t < set.size(); ++t) {
      wrong += components.of_triangle[t] != (t < 2 * 150 * 90 ? 0 : 1) || signed_area_up(set, t) < 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("triangles that are left out part a sheet, and components count from their first triangles") {
  Strips strips;
  strips.add(100, 100, false, false, 0);
  strips.turn_some();
  TriangleSet set = strips.set();
  Selection selected(set.size(), 1);
  for (Index t = 2 * 100 * 40; t < 2 * 100 * 41; ++t) selected[t] = 0;  // a column of squares
  const Components components = find_components(set, selected);
  set = turn_over(std::move(set), components.turned);
  REQUIRE(components.count() == 2);
  for (const Index t : {Index{0}, Index{2 * 100 * 40 - 1}}) CHECK(components.of_triangle[t] == 0);
  for (const Index t : {Index{2 * 100 * 41}, set.size() - 1}) CHECK(components.of_triangle[t] == 1);
  CHECK(components.of_triangle[2 * 100 * 40] == none);
  CHECK(disagreements(set, selected) == 0);
}

TEST_CASE(
    "a ring of many blocks is orientable, with half a twist it is not and disagrees at one seam alone") {
  for (const bool twisted : {false, true}) {
    Strips strips;
    strips.add(3000, 4, true, twisted, 0);
    strips.turn_some();
    TriangleSet set = strips.set();
    const Selection selected(set.size(), 1);
    const Components components = find_components(set, selected);
    set = turn_over(std::move(set), components.turned);
    REQUIRE(components.count() == 1);
    CHECK(bool(components.orientable[0]) == !twisted);
    const int seam = disagreements(set, selected);
    CHECK((twisted ? seam > 0 && seam < 12 : seam == 0));
  }
}
