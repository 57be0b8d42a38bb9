// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/closed_paths.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"

namespace rimline {
namespace {

// Algorithm 3.1 as it is printed, with its recursion and its flags; only the point that closes the path is
// marked before it returns (docs/departures.md).
class NaiveAlgorithm31 {
 public:
  NaiveAlgorithm31(const Neighbours& neighbours, const std::vector<std::uint8_t>& is_boundary,
                   std::size_t threshold)
      : neighbours_(neighbours), is_boundary_(is_boundary), threshold_(threshold) {}

  std::vector<Index> path(Index start) {
    passed_.assign(is_boundary_.size(), false);
    in_path_.clear();
    return find(start, start) ? in_path_ : std::vector<Index>{};
  }

 private:
  bool find(Index p, Index b) {
    const auto near = neighbours_.of(p);
    const bool reaches_start = std::find(near.begin(), near.end(), b) != near.end();
    if (in_path_.size() >= threshold_ && reaches_start) {
      in_path_.push_back(p);
      return true;
    }
    passed_[p] = true;
    in_path_.push_back(p);
    for (const Index q : near) {
      if (is_boundary_[q] && !passed_[q] && find(q, b)) return true;
    }
    in_path_.pop_back();
    return false;
  }

  const Neighbours& neighbours_;
  const std::vector<std::uint8_t>& is_boundary_;
  std::size_t threshold_;
  std::vector<bool> passed_;
  std::vector<Index> in_path_;
};

// A random directed graph in the form of neighbour lists; distances do not matter to Algorithm 3.1.
Neighbours random_graph(int points, int k, Random& random) {
  Neighbours graph;
  graph.k = k;
  for (Index i = 0; i < points; ++i) {
    std::vector<Index> others;
    for (Index j = 0; j < points; ++j) {
      if (j != i) others.push_back(j);
    }
    random.shuffle(others);
    graph.ids.insert(graph.ids.end(), others.begin(), others.begin() + k);
  }
  return graph;
}

TEST_CASE("on random graphs of at most 12 points every path is that of Algorithm 3.1 written naively") {
  Random random(5);
  int closed = 0, open = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const int points = 3 + static_cast<int>(random.below(10)),
              k = 1 + static_cast<int>(random.below(std::min(points - 1, 5)));
    const int threshold = 1 + static_cast<int>(random.below(points));
    const Neighbours graph = random_graph(points, k, random);
    std::vector<std::uint8_t> candidate(points);
    for (auto& c : candidate) c = random.uniform() < 0.75;
    ClosedPathSearcher searcher(graph, candidate, k, threshold);
    NaiveAlgorithm31 naive(graph, candidate, threshold);
    for (Index start = 0; start < points; ++start) {
      if (!candidate[start]) continue;
      const auto path = searcher.find(start);
      CHECK(path == naive.path(start));
      path.empty() ? ++open : ++closed;
    }
  }
  CHECK(closed > 1000);  // the trials must see both outcomes
  CHECK(open > 1000);
}

TEST_CASE("a path closes with k + 1 points before its last, where no threshold is given") {
  Random random(6);
  int differ = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int points = 9, k = 1 + static_cast<int>(random.below(4));
    const Neighbours graph = random_graph(points, k, random);
    const std::vector<std::uint8_t> candidate(points, 1);
    ClosedPathSearcher searcher(graph, candidate, k, 0);
    NaiveAlgorithm31 naive(graph, candidate, k + 1), less(graph, candidate, k), more(graph, candidate, k + 2);
    for (Index start = 0; start < points; ++start) {
      const auto path = searcher.find(start);
      CHECK(path == naive.path(start));
      differ += path != less.path(start) && path != more.path(start);
    }
  }
  CHECK(differ > 100);
}

// Points in a ring, each with its two neighbours on either side.
Neighbours ring(int points) {
  Neighbours graph;
  graph.k = 2;
  for (Index i = 0; i < points; ++i) {
    graph.ids.push_back((i + 1) % points);
    graph.ids.push_back((i + points - 1) % points);
  }
  return graph;
}

BoundaryScores uniform_scores(int points) {
  return {std::vector<double>(points, 5.0), std::vector<std::uint8_t>(points, 1),
          std::vector<float>(points, 0.4f)};
}

TEST_CASE("a ring of candidates is one closed path, found from every start and kept once") {
  LoopOptions options;
  options.path_k = 2;
  options.path_threshold = 10;
  const ClosedPaths paths = find_closed_paths(ring(40), uniform_scores(40), options, {});
  CHECK(paths.starts == 40);
  CHECK(paths.closed == 40);
  CHECK(paths.distinct == 1);
  CHECK(paths.best.size() == 1);
  CHECK(paths.best[0].ids.size() == 40);
  CHECK_FALSE(paths.bound_hit);
}

TEST_CASE("of the distinct paths the fittest make up the population, best first") {
  Neighbours rings;
  rings.k = 2;
  BoundaryScores scores = uniform_scores(60);
  for (int r = 0; r < 5; ++r) {  // five rings of twelve points, the third with the highest scores
    const Neighbours one = ring(12);
    for (const Index id : one.ids) rings.ids.push_back(id + 12 * r);
    for (int i = 0; i < 12; ++i) scores.log_score[12 * r + i] = r == 2 ? 50 : 5 + r;
  }
  LoopOptions options;
  options.path_k = 2;
  options.population = 3;
  const ClosedPaths paths = find_closed_paths(rings, scores, options, {});
  CHECK(paths.distinct == 5);
  REQUIRE(paths.best.size() == 3);
  for (const auto& [rank, first] : {std::pair{0, 24}, {1, 48}, {2, 36}})
    CHECK(paths.best[rank].ids[0] == first);
}

TEST_CASE("the bound on the work is kept and said") {
  LoopOptions options;
  options.path_k = 2;
  options.path_threshold = 10;
  options.max_path_steps = 1;
  const ClosedPaths paths = find_closed_paths(ring(400), uniform_scores(400), options, {});
  CHECK(paths.bound_hit);
  CHECK(paths.starts < 400);
  CHECK(paths.starts > 0);
}

TEST_CASE("a path of 200,000 points needs no deep stack") {
  LoopOptions options;
  options.path_k = 2;
  options.path_threshold = 100;
  options.max_path_steps = 1;
  const ClosedPaths paths = find_closed_paths(ring(200'000), uniform_scores(200'000), options, {});
  REQUIRE(paths.best.size() == 1);
  CHECK(paths.best[0].ids.size() == 200'000);
}

}  // namespace
}  // namespace rimline
