// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/multigrid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace rimline {
namespace {

// The Laplacian of a square lattice with side * side unknowns and random positive weights; its border is
// held at 0.
SymmetricMatrix lattice(int side, double spread, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto weight = [&] {
    return std::pow(spread, static_cast<double>(random() >> 11) / 9007199254740992.0);
  };
  std::vector<double> right(side * (side + 1)), up(side * (side + 1));
  for (double& w : right) w = weight();
  for (double& w : up) w = weight();
  SymmetricMatrix a;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double west = right[y * (side + 1) + x], east = right[y * (side + 1) + x + 1];
      const double south = up[y * side + x], north = up[(y + 1) * side + x];
      const auto add = [&](bool inside, int at, double w) {
        if (!inside) return;
        a.columns.push_back(at);
        a.values.push_back(-w);
      };
      const int i = y * side + x;
      add(y > 0, i - side, south);
      add(x > 0, i - 1, west);
      add(x + 1 < side, i + 1, east);
      add(y + 1 < side, i + side, north);
      a.diagonal.push_back(west + east + south + north);
      a.offsets.push_back(static_cast<Index>(a.columns.size()));
    }
  }
  return a;
}

std::vector<UV> times(const SymmetricMatrix& a, const std::vector<UV>& x) {
  std::vector<UV> result(x.size());
  for (Index i = 0; i < a.size(); ++i) result[i] = a.diagonal[i] * x[i] + a.off_diagonal(i, x.data());
  return result;
}

std::vector<UV> random_vector(std::size_t size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<UV> x(size);
  for (UV& p : x) p = {static_cast<double>(random() % 1000), static_cast<double>(random() % 1000) - 500};
  return x;
}

double product(const std::vector<UV>& a, const std::vector<UV>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].u * b[i].u;
  return sum;
}

}  // namespace

TEST_CASE("the solution is the one that made the right-hand side") {
  const Run run;
  for (const int side : {1, 5, 17, 40, 120}) {
    for (const double spread : {1.0, 1e3}) {
      CAPTURE(side);
      CAPTURE(spread);
      const SymmetricMatrix a = lattice(side, spread, 7);
      const std::vector<UV> expected = random_vector(a.diagonal.size(), 3);
      const std::vector<UV> b = times(a, expected);
      Multigrid multigrid(a, run);
      std::vector<UV> x(b.size());
      const SolveResult result = solve(multigrid, b, 1e-12, 200, x, run);
      CHECK(result.residual <= 1e-11);
      double worst = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        worst = std::max({worst, std::abs(x[i].u - expected[i].u), std::abs(x[i].v - expected[i].v)});
      }
      CHECK(worst < 1e-5);
    }
  }
}

TEST_CASE("the number of iterations hardly grows with the number of unknowns") {
  const Run run;
  for (const int side : {40, 160, 320}) {
    Multigrid multigrid(lattice(side, 10, 1), run);
    const std::vector<UV> b = random_vector(static_cast<std::size_t>(side) * side, 2);
    std::vector<UV> x(b.size());
    const SolveResult result = solve(multigrid, b, 1e-10, 200, x, run);
    CHECK(result.residual <= 1.01e-10);
    CHECK(result.iterations <= 30);
    CHECK(multigrid.operator_complexity() < 2);
  }
}

TEST_CASE("the cycle is a symmetric positive operator, also across blocks") {
  const Run run;
  Multigrid multigrid(lattice(150, 10, 4), run);  // 22,500 unknowns: three blocks
  const std::vector<UV> a = random_vector(22500, 5), b = random_vector(22500, 6);
  std::vector<UV> ma(a.size()), mb(b.size());
  multigrid.precondition(a, ma);
  multigrid.precondition(b, mb);
  CHECK(product(ma, b) == doctest::Approx(product(a, mb)).epsilon(1e-10));
  CHECK(product(ma, a) > 0);
}

TEST_CASE("the bytes of the solution do not depend on the number of threads") {
  const SymmetricMatrix a = lattice(200, 10, 9);
  const std::vector<UV> b = random_vector(a.diagonal.size(), 8);
  std::vector<std::vector<UV>> solutions;
  for (const int threads : {1, 2}) {
    Run run;
    run.threads = threads;
    Multigrid multigrid(a, run);
    solutions.emplace_back(b.size());
    solve(multigrid, b, 1e-10, 100, solutions.back(), run);
  }
  CHECK(std::memcmp(solutions[0].data(), solutions[1].data(), b.size() * sizeof(UV)) == 0);
}

TEST_CASE("a cancelled run stops the solve") {
  std::atomic<bool> stop = false;
  Run run;
  run.stop = &stop;
  Multigrid multigrid(lattice(50, 1, 1), run);
  const std::vector<UV> b = random_vector(2500, 1);
  std::vector<UV> x(b.size());
  stop = true;
  CHECK_THROWS_AS(solve(multigrid, b, 1e-10, 100, x, run), Error);
}

}  // namespace rimline
