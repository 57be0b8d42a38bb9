// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "paper/fitness.h"
#include "paper/winner.h"
#include "rimline/find_genetic_loop.h"
#include "shapes.h"

namespace rimline {
namespace {

bool is_rotation_or_reverse(std::vector<Index> loop, const std::vector<Index>& wanted) {
  if (loop.size() != wanted.size()) return false;
  for (int turn = 0; turn < 2; ++turn) {
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), wanted[0]), loop.end());
    if (loop == wanted) return true;
    std::reverse(loop.begin(), loop.end());
  }
  return false;
}

TEST_CASE("the band of candidates of a disc is ordered into its rim") {
  const auto disc = shapes::disc(14);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  std::vector<Index> band;
  for (Index i = 0; i < static_cast<Index>(disc.points.size()); ++i) {
    if (scores.candidate[i]) band.push_back(i);
  }
  REQUIRE(band.size() > disc.rim.size());  // the band is wider than the rim, or there is nothing to show
  CHECK(is_rotation_or_reverse(order_loop(disc.points, neighbours, 40, scores, band).points, disc.rim));
}

// Points of a chain along the unit circle, `width` abreast, and the scores of candidates.
struct Chain {
  std::vector<Point> points;
  Neighbours neighbours;
  BoundaryScores scores;
  std::vector<Index> all;
};

Chain chain(int count, int width, double turn) {
  Chain c;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < width; ++j) {
      const double angle = turn * 2 * std::numbers::pi * i / count, radius = 1 - 0.03 * j;
      c.all.push_back(static_cast<Index>(c.points.size()));
      c.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
      c.scores.log_score.push_back(5.0 - j);
    }
  }
  c.scores.candidate.assign(c.points.size(), 1);
  c.scores.delta.assign(c.points.size(), 0.4F);
  c.neighbours = find_neighbours(c.points, 12, {});
  return c;
}

TEST_CASE("the loop of a whole ring goes round its band, that of a broken ring does not") {
  const Chain whole = chain(120, 3, 1), broken = chain(120, 3, 0.8);
  const OrderedLoop rim = order_loop(whole.points, whole.neighbours, 12, whole.scores, whole.all);
  CHECK(rim.goes_round);
  CHECK(rim.points.size() == 120);  // the outermost points, which have the highest scores
  for (const Index id : rim.points) CHECK(id % 3 == 0);
  CHECK_FALSE(order_loop(broken.points, broken.neighbours, 12, broken.scores, broken.all).goes_round);
}

TEST_CASE("a loop about a part of its band does not go round it") {
  Chain c = chain(120, 3, 0.8);  // a long broken ring, and a small whole one beside it
  const Chain small = chain(30, 1, 1);
  for (const Point& p : small.points) {
    c.all.push_back(static_cast<Index>(c.points.size()));
    c.points.push_back(Point{5, 0, 0} + p);
    c.scores.log_score.push_back(5);
    c.scores.candidate.push_back(1);
    c.scores.delta.push_back(0.4F);
  }
  c.neighbours = find_neighbours(c.points, 4, {});
  const OrderedLoop loop = order_loop(c.points, c.neighbours, 4, c.scores, c.all);
  CHECK_FALSE(loop.goes_round);
}

TEST_CASE("where the fittest chromosome is a broken ring, the next one that closes is the winner") {
  const Chain c = chain(120, 3, 1);
  std::vector<Index> arc, ring;
  for (const Index id : c.all) {
    if (id < 30) arc.push_back(id);
    if (id % 3 == 0) ring.push_back(id);
  }
  LoopOptions options;
  options.path_k = 12;
  options.generations = 0;
  ClosedPaths paths;
  paths.best = {{arc, 9}, {{0, 1, 2}, 8}, {ring, 7}};
  const GeneticLoop found = breed_loop(c.points, c.neighbours, c.scores, paths, options, {});
  CHECK(found.winner == ring);
  CHECK(found.search.loop_from == LoopSource::Later);
  CHECK(found.search.winner_rank == 2);
  CHECK(found.search.population == 3);
  CHECK(found.search.winner_fitness == doctest::Approx(fitness(ring, c.scores, options)));
  paths.best = {{ring, 7}};
  CHECK(breed_loop(c.points, c.neighbours, c.scores, paths, options, {}).search.loop_from ==
        LoopSource::Fittest);
  paths.best = {{arc, 9}};
  CHECK_THROWS_AS(breed_loop(c.points, c.neighbours, c.scores, paths, options, {}), Error);
}

TEST_CASE("where no chromosome that the search kept closes, the best initial path that does is the winner") {
  const Chain c = chain(120, 3, 1);
  std::vector<Index> arc, ring;
  for (const Index id : c.all) {
    if (id % 3 == 0) (id < 90 ? arc : ring).push_back(id);
  }
  std::vector<Index> whole = arc;
  whole.insert(whole.end(), ring.begin(), ring.end());
  LoopOptions options;  // the log of the score: a chromosome of few points with high scores is fitter
  options.path_k = 6;
  options.length_exponent = 1.5;
  options.mutation_probability = 0.05;
  options.population = 2;
  ClosedPaths paths;
  paths.best = {{arc, log_fitness(arc, c.scores, options)}, {whole, log_fitness(whole, c.scores, options)}};
  const GeneticLoop found = breed_loop(c.points, c.neighbours, c.scores, paths, options, {});
  CHECK(found.search.loop_from == LoopSource::InitialPath);
  CHECK(found.winner == whole);
  CHECK(found.search.winner_rank == 1);
}

TEST_CASE(
    "a loop of more than path_k points closes, also where triangles fill it; of path_k points it does not") {
  Chain wheel = chain(12, 1, 1);  // a ring, and a hub above it that every point of the ring is joined to
  wheel.points.push_back({0, 0, 1.2});
  wheel.all.push_back(12);
  wheel.scores.log_score.push_back(1);
  wheel.scores.candidate.push_back(1);
  wheel.neighbours.k = 3;
  wheel.neighbours.ids.clear();
  for (Index i = 0; i < 13; ++i) {
    for (const Index q : {(i + 1) % 12, (i + 11) % 12, i < 12 ? 12 : 0}) wheel.neighbours.ids.push_back(q);
  }
  LoopOptions options;
  options.generations = 0;
  ClosedPaths paths;
  paths.best = {{wheel.all, 1}};
  options.path_k = 11;
  const OrderedLoop loop = order_loop(wheel.points, wheel.neighbours, 11, wheel.scores, wheel.all);
  CHECK(loop.points.size() == 12);
  CHECK_FALSE(loop.goes_round);
  CHECK(breed_loop(wheel.points, wheel.neighbours, wheel.scores, paths, options, {}).loop.points ==
        loop.points);
  options.path_k = 12;
  CHECK_THROWS_AS(breed_loop(wheel.points, wheel.neighbours, wheel.scores, paths, options, {}), Error);
}

TEST_CASE("an open arc has no order") {
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i) points.push_back({1.0 * i * (i + 1), 0, 0});
  const Neighbours neighbours = find_neighbours(points, 1, {});
  const BoundaryScores scores{std::vector<double>(30, 5.0), std::vector<std::uint8_t>(30, 1),
                              std::vector<float>(30, 0.4f)};
  std::vector<Index> all(30);
  for (Index i = 0; i < 30; ++i) all[i] = i;
  CHECK(order_loop(points, neighbours, 1, scores, all).points.empty());
}

TEST_CASE("Algorithms 3.1 and 3.2 and the order find the rim of a bumpy disc") {
  const auto disc = shapes::disc(16, 0.3);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  const GeneticLoop found = find_genetic_loop(disc.points, neighbours, scores, {}, {});
  CHECK(is_rotation_or_reverse(found.loop.points, disc.rim));
  CHECK(found.search.history.size() == 101);
  CHECK(found.loop.length == doctest::Approx(loop_length(disc.points, disc.rim)));
}

TEST_CASE("a set without a closed path says so") {
  const auto disc = shapes::disc(14);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  scores.candidate.assign(scores.candidate.size(), 0);
  CHECK_THROWS_AS(find_genetic_loop(disc.points, neighbours, scores, {}, {}), Error);
}

}  // namespace
}  // namespace rimline
