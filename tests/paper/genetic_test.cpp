// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/genetic.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "paper/fitness.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

TEST_CASE("a chromosome gives back the bits that were set") {
  const std::vector<Index> ids{0, 1, 63, 64, 127, 128, 199};
  CHECK(Chromosome(200, ids).ids() == ids);
}

TEST_CASE("crossover swaps exactly the bits from the cut on") {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Index> a, b, a_after, b_after;
    const Index cut = static_cast<Index>(random.below(150));
    for (Index bit = 0; bit < 150; ++bit) {
      const bool in_a = random.uniform() < 0.5, in_b = random.uniform() < 0.5;
      if (in_a) a.push_back(bit);
      if (in_b) b.push_back(bit);
      if (bit < cut ? in_a : in_b) a_after.push_back(bit);
      if (bit < cut ? in_b : in_a) b_after.push_back(bit);
    }
    Chromosome first(150, a), second(150, b);
    Chromosome::exchange_tails(first, second, cut);
    CHECK(first.ids() == a_after);
    CHECK(second.ids() == b_after);
  }
}

// p-values 1/2, 1/4, 1/8, ...
BoundaryScores halving_scores(int points) {
  BoundaryScores scores;
  for (int i = 0; i < points; ++i) scores.log_score.push_back((i + 1) * std::log(2.0));
  scores.candidate.assign(points, 1);
  scores.delta.assign(points, 0.4f);
  return scores;
}

TEST_CASE("eq. (3) by hand, as printed, capped and with the log of the score") {
  const BoundaryScores scores = halving_scores(4);
  const std::vector<Index> ids{0, 1, 3};
  LoopOptions options;
  options.score_form = ScoreForm::Printed;
  CHECK(fitness(ids, scores, options) == doctest::Approx((2 + 4 + 16) / std::pow(3, 0.9)));
  options.score_form = ScoreForm::Log;
  CHECK(fitness(ids, scores, options) == doctest::Approx((1 + 2 + 4) * std::log(2.0) / std::pow(3, 0.9)));
  options.length_exponent = 0.5;
  CHECK(fitness(ids, scores, options) == doctest::Approx(7 * std::log(2.0) / std::sqrt(3.0)));
  options = {.score_form = ScoreForm::Capped, .score_cap = 0.2};  // of 1/2, 1/4 and 1/16 the last is capped
  CHECK(fitness(ids, scores, options) == doctest::Approx((2 + 4 + 5) / std::pow(3, 0.9)));
}

TEST_CASE("eq. (3) as printed stays finite where 1/p leaves the range of double") {
  BoundaryScores scores = halving_scores(2);
  scores.log_score = {5000, 4000};
  LoopOptions options;
  options.score_form = ScoreForm::Printed;
  const std::vector<Index> both{0, 1}, one{1};
  CHECK(log_fitness(both, scores, options) == doctest::Approx(5000 - 0.9 * std::log(2.0)));
  CHECK(std::isfinite(fitness(both, scores, options)));
  CHECK(log_fitness(one, scores, options) < log_fitness(both, scores, options));
}

std::vector<ClosedPath> three_paths(const BoundaryScores& scores, const LoopOptions& options) {
  std::vector<ClosedPath> paths;
  for (const std::vector<Index>& ids : {std::vector<Index>{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}) {
    paths.push_back({ids, log_fitness(ids, scores, options)});
  }
  return paths;
}

TEST_CASE("the search never loses the best chromosome it has seen, and tells its history") {
  const BoundaryScores scores = halving_scores(12);
  LoopOptions options;
  options.generations = 20;
  const auto initial = three_paths(scores, options);
  const Evolution evolution = evolve(initial, scores, options, {});
  CHECK(evolution.history.size() == 21);
  double best = 0;
  for (const Generation& g : evolution.history) {
    CHECK(g.mean <= g.best * (1 + 1e-12));
    best = std::max(best, g.best);
  }
  CHECK(std::exp(evolution.fittest.front().log_fitness) == doctest::Approx(best));
  CHECK(evolution.fittest.front().log_fitness >= initial[2].log_fitness);
}

TEST_CASE("selection is in proportion to fitness") {
  // Half of the chromosomes are three times as fit as the others; bits are so far from the end that a cut
  // between them is rare. One generation makes three quarters of them fit: a mean of 2.5 where it was 2.
  constexpr int length = 100'000, pairs = 1500;
  BoundaryScores scores;
  scores.log_score.assign(length, 0);
  scores.log_score[0] = std::log(3.0);
  scores.candidate.assign(length, 0);
  LoopOptions options;
  options.score_form = ScoreForm::Printed;
  options.mutation_probability = 0;
  options.generations = 1;
  std::vector<ClosedPath> initial;
  for (int i = 0; i < pairs; ++i) {
    for (const Index id : {0, 1}) initial.push_back({{id}, scores.log_score[id]});
  }
  const Evolution evolution = evolve(initial, scores, options, {});
  REQUIRE(evolution.history.size() == 2);
  CHECK(evolution.history[0].mean == doctest::Approx(2));
  CHECK(evolution.history[1].mean == doctest::Approx(2.5).epsilon(0.03));
}

TEST_CASE("the best chromosome of each generation is told from generation 0 on, with its fitness") {
  const BoundaryScores scores = halving_scores(40);
  LoopOptions options;
  options.generations = 30;
  options.mutation_probability = 0.02;
  const auto initial = three_paths(scores, options);
  const Evolution evolution = evolve(initial, scores, options, {});
  const auto& told = evolution.best.generations();
  REQUIRE(told.size() == 31);
  CHECK(told[0].points == initial[2].ids);
  for (std::size_t g = 0; g < told.size(); ++g) {
    CHECK(told[g].generation == static_cast<int>(g));
    CHECK(told[g].fitness == evolution.history[g].best);
    CHECK(told[g].fitness == doctest::Approx(fitness(told[g].points, scores, options)));
  }
}

TEST_CASE("a long history is thinned evenly, and keeps generation 0") {
  SearchHistory history;
  const std::vector<Index> points(SearchHistory::most_points / 10, 1);
  for (int g = 0; g <= 100; ++g) history.add({g, 1.0 * g, points});
  CHECK(history.stride() == 16);
  REQUIRE(history.generations().size() == 7);
  for (int i = 0; i < 7; ++i) CHECK(history.generations()[i].generation == 16 * i);
}

TEST_CASE("mutation sets only bits of candidates") {
  BoundaryScores scores = halving_scores(500);
  for (Index i = 0; i < 500; i += 2) scores.candidate[i] = 0;
  LoopOptions options;
  options.mutation_probability = 0.2;
  std::vector<ClosedPath> initial;
  for (const std::vector<Index>& ids : {std::vector<Index>{1, 3, 5}, {7, 9, 11}})
    initial.push_back({ids, 1.0});
  const Evolution evolution = evolve(initial, scores, options, {});
  bool mutated = false;
  for (const ClosedPath& path : evolution.fittest) {
    for (const Index id : path.ids) {
      CHECK(id % 2 == 1);
      mutated |= id > 11;
    }
  }
  CHECK(mutated);
}

TEST_CASE("the same seed gives the same history and another seed another") {
  const BoundaryScores scores = halving_scores(64);
  LoopOptions options;
  options.mutation_probability = 0.05;
  const auto history = [&](std::uint64_t seed) {
    Run run;
    run.seed = seed;
    std::vector<double> means;
    for (const Generation& g : evolve(three_paths(scores, options), scores, options, run).history) {
      means.push_back(g.mean);
    }
    return means;
  };
  CHECK(history(7) == history(7));
  CHECK(history(7) != history(8));
}

}  // namespace
}  // namespace rimline
