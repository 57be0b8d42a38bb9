// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/aggregation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace rimline {
namespace {

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) / 9007199254740992.0; }

// A walk on a square lattice of side * side places: each row goes to its neighbours with random weights, and
// to some of them only one way. Where `held(x, y)` says so, a row also goes to what is held at 0.
template <class Held>
RowMatrix walk(int side, double one_way, double spread, unsigned seed, const Held& held) {
  std::mt19937_64 random(seed);
  std::vector<double> weights(2 * side * side);
  for (double& w : weights) w = std::pow(spread, uniform(random));
  const auto weight = [&](int x, int y, int dx, int dy) {  // the same from both ends
    const int ex = std::min(x, x + dx), ey = std::min(y, y + dy);
    return weights[2 * (ey * side + ex) + (dy != 0)];
  };
  RowMatrix a;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      double sum = held(x, y) ? 1 : 0;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        const int tx = x + dx, ty = y + dy;
        if (tx < 0 || ty < 0 || tx >= side || ty >= side) continue;
        // Never on both first steps, so that a chain of entries leads on from every row.
        if (dx + dy < 0 && uniform(random) < one_way) continue;
        const double w = weight(x, y, dx, dy);
        sum += w;
        a.columns.push_back(ty * side + tx);
        a.values.push_back(-w);
      }
      a.diagonal.push_back(sum);
      a.offsets.push_back(static_cast<Index>(a.columns.size()));
    }
  }
  return a;
}

// Rows held at the far corner alone: where all one-way steps lead to.
auto corner(int side) {
  return [side](int x, int y) { return x == side - 1 && y == side - 1; };
}

std::vector<UV> times(const RowMatrix& a, const std::vector<double>& scale, const std::vector<UV>& x) {
  std::vector<UV> result(x.size());
  for (Index i = 0; i < a.size(); ++i) result[i] = (1 / scale[i]) * a.times(i, x.data());
  return result;
}

std::vector<UV> smooth_vector(int side) {
  std::vector<UV> x;
  for (int i = 0; i < side * side; ++i) x.push_back({std::sin(0.01 * i), 1 + std::cos(0.02 * (i % side))});
  return x;
}

}  // namespace

TEST_CASE("the solution of one-sided walks is the one that made the right-hand side") {
  const Run run;
  for (const int side : {1, 4, 20, 60, 120}) {
    for (const double one_way : {0.0, 0.1, 0.5}) {
      CAPTURE(side);
      CAPTURE(one_way);
      const RowMatrix a = walk(side, one_way, 100, 7, corner(side));
      const std::vector<UV> expected = smooth_vector(side);
      const std::vector<UV> b = times(a, a.diagonal, expected);
      AggregationMultigrid multigrid(a, run);
      std::vector<UV> x(b.size());
      const ConvexSolve result = solve(multigrid, a.diagonal, b, 1e-13, 500, x, run);
      CHECK(result.residual <= 1e-12);
      double worst = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        worst = std::max({worst, std::abs(x[i].u - expected[i].u), std::abs(x[i].v - expected[i].v)});
      CHECK(worst < 1e-4);
    }
  }
}

TEST_CASE("a walk that hardly ever ends is solved in few steps") {
  const Run run;
  for (const int side : {100, 300}) {
    const RowMatrix a = walk(side, 0.1, 100, 3, corner(side));
    std::vector<UV> b(a.diagonal.size());
    b.back() = {1, -1};  // what is held has these values, and so has everything
    AggregationMultigrid multigrid(a, run);
    CHECK(multigrid.levels() > 2);
    std::vector<UV> x(b.size());
    const std::vector<double> scale(b.size(), 1);
    const ConvexSolve result = solve(multigrid, scale, b, 1e-10, 500, x, run);
    CHECK(result.residual <= 1e-10);
    CHECK(result.iterations <= 60);
    for (std::size_t i = 0; i < x.size(); i += 97) CHECK(x[i].u == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("the bytes of the solution of one-sided walks do not depend on the number of threads") {
  const RowMatrix a = walk(200, 0.2, 10, 9, corner(200));
  const std::vector<UV> b = times(a, a.diagonal, smooth_vector(200));
  std::vector<std::vector<UV>> solutions;
  for (const int threads : {1, 2}) {
    Run run;
    run.threads = threads;
    AggregationMultigrid multigrid(a, run);
    solutions.emplace_back(b.size());
    solve(multigrid, a.diagonal, b, 1e-10, 100, solutions.back(), run);
  }
  CHECK(std::memcmp(solutions[0].data(), solutions[1].data(), b.size() * sizeof(UV)) == 0);
}

TEST_CASE("a cancelled run stops the solve of one-sided walks") {
  std::atomic<bool> stop = false;
  Run run;
  run.stop = &stop;
  const RowMatrix a = walk(50, 0.1, 1, 1, corner(50));
  AggregationMultigrid multigrid(a, run);
  const std::vector<UV> b(a.diagonal.size(), UV{1, 1});
  std::vector<UV> x(b.size());
  stop = true;
  CHECK_THROWS_AS(solve(multigrid, a.diagonal, b, 1e-10, 100, x, run), Error);
}

}  // namespace rimline
