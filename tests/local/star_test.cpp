// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/star.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "surface/propose.h"

using namespace rimline;

namespace {

// Sparse on the left and dense on the right: points of the dense side are in lists that are not in theirs.
std::vector<Point> step_of_density(int count) {
  Random random(5);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double x = i % 5 == 0 ? -random.uniform() : 0.3 * random.uniform();
    points.push_back({x, 0.3 * random.uniform(), 0});
  }
  return points;
}

struct Side {
  double x, y;
  Index id;
};

// A square, clipped by the bisector of every point that is a neighbour in either direction, none left out.
std::vector<Index> star_the_long_way(Points p, const Neighbours& n, const std::vector<double>& spacing,
                                     Index self) {
  const double h = 20 * spacing[self];
  std::vector<Side> cell{{-h, -h, none}, {h, -h, none}, {h, h, none}, {-h, h, none}};
  for (Index other = 0; other < n.size(); ++other) {
    const auto own = n.of(self), others = n.of(other);
    if (std::find(own.begin(), own.end(), other) == own.end() &&
        std::find(others.begin(), others.end(), self) == others.end())
      continue;
    const double a = p[other].x - p[self].x, b = p[other].y - p[self].y, c = (a * a + b * b) / 2;
    std::vector<Side> next;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Side &from = cell[i], &to = cell[(i + 1) % cell.size()];
      const double at = a * from.x + b * from.y - c, then = a * to.x + b * to.y - c;
      if (at <= 0) next.push_back(from);
      if ((at <= 0) == (then <= 0)) continue;
      const double t = at / (at - then);
      next.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), at <= 0 ? other : from.id});
    }
    cell = next;
  }
  std::vector<Index> star;
  for (const Side& side : cell) star.push_back(side.id);
  return star;
}

// From its least id on.
std::vector<Index> turned(std::vector<Index> star) {
  std::rotate(star.begin(), std::min_element(star.begin(), star.end()), star.end());
  return star;
}

}  // namespace

TEST_CASE("stars are those of cells cut by all neighbours in both directions, for any number of threads") {
  const auto points = step_of_density(6000);
  const Neighbours neighbours = find_neighbours(points, 12, {});
  const auto spacing = local_spacing(points, neighbours);
  const std::vector<Frame> frames(points.size(), Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0});
  Run run;
  run.threads = 1;
  const Stars stars = find_stars(points, neighbours, spacing, frames, run);
  run.threads = 3;
  const Stars again = find_stars(points, neighbours, spacing, frames, run);
  REQUIRE(stars.size() == points.size());
  int wrong = 0, different = 0, one_way = 0;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const std::vector<Index> star(stars[i].begin(), stars[i].end());
    different += !std::equal(star.begin(), star.end(), again[i].begin(), again[i].end());
    if (i % 7 != 0) continue;
    const auto expected = star_the_long_way(points, neighbours, spacing, i);
    if (std::count(expected.begin(), expected.end(), none) > 1) continue;  // open ends may differ in corners
    wrong += turned(star) != turned(expected);
    for (const Index s : star) {
      const auto own = neighbours.of(i);
      one_way += s != none && std::find(own.begin(), own.end(), s) == own.end();
    }
  }
  CHECK(wrong == 0);
  CHECK(different == 0);
  CHECK(one_way > 0);
}

TEST_CASE("weighted stars reproduce linear functions on flat uneven points, for any number of threads") {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  const Neighbours neighbours = find_neighbours(points, 24, {});
  Run run;
  run.threads = 1;
  const Stars stars = find_weighted_stars(points, neighbours, run);
  run.threads = 3;
  const Stars again = find_weighted_stars(points, neighbours, run);
  int closed = 0, different = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Star star = stars[i];
    different +=
        !std::ranges::equal(star, again[i]) || !std::ranges::equal(stars.weights(i), again.weights(i));
    if (std::ranges::find(star, none) != star.end()) continue;
    ++closed;
    Point off{};
    double size = 0;
    for (std::size_t e = 0; e < star.size(); ++e) {
      off = off + stars.weights(i)[e] * (points[star[e]] - points[i]);
      size += stars.weights(i)[e] * distance(points[star[e]], points[i]);
    }
    CHECK(norm(off) < 1e-5 * size);  // ties are settled by weights of 5e-8
  }
  CHECK(closed > 2500);
  CHECK(different == 0);
}

TEST_CASE("triangles taken all at once are the same set as one after another") {
  const auto points = step_of_density(4000);
  const Neighbours neighbours = find_neighbours(points, 20, {});
  const auto spacing = local_spacing(points, neighbours);
  const std::vector<Frame> frames = fit_frames(points, neighbours, {});
  const Stars stars = find_stars(points, neighbours, spacing, frames, {});
  const TriangleSet all = propose_surface(points, frames, stars, spacing, 3, {});
  TriangleSet one(points, frames);
  for (Index t = 0; t < all.size(); ++t) one.add(all.triangle(t));
  int different = 0;
  for (Index t = 0; t < all.size(); ++t) {
    different += all.radius(t) != one.radius(t);
    for (int i = 0; i < 3; ++i) different += all.across(t, i) != one.across(t, i);
  }
  for (Index v = 0; v < all.vertices(); ++v) {
    const auto a = all.star(v), b = one.star(v);
    different += !std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  CHECK(all.size() > 4000);
  CHECK(different == 0);
}
