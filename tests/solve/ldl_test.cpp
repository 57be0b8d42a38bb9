// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/ldl.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <atomic>
#include <cmath>
#include <random>

namespace rimline {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// The lower triangle of a random matrix; the larger `diagonal`, the surer it is positive definite.
Matrix random_lower(int size, int per_row, double diagonal, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] { return static_cast<double>(random() >> 11) / 9007199254740992.0 - 0.5; };
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, diagonal + number());
    for (int e = 0; e < per_row && i > 0; ++e)
      entries.emplace_back(i, static_cast<int>(random() % static_cast<unsigned>(i)), number());
  }
  Matrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

Eigen::VectorXd ramp(Eigen::Index size) { return Eigen::VectorXd::LinSpaced(size, -1, 2); }

}  // namespace

TEST_CASE("a dense solver gives the same, also where the matrix is indefinite") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Matrix lower = random_lower(40, 3, seed % 2 == 0 ? 4 : 0.1, seed);
    const Eigen::MatrixXd whole(Matrix(lower.selfadjointView<Eigen::Lower>()));
    const Eigen::VectorXd right = ramp(40), expected = whole.fullPivLu().solve(right);
    const LdlFactor factor(lower, {});
    REQUIRE(factor.is_regular());
    const Eigen::VectorXd x = factor.solve(right);
    CHECK((x - expected).norm() <= 1e-6 * expected.norm());
  }
}

TEST_CASE("the numbers are those of Eigen's factorization, which can not be stopped") {
  const Matrix lower = random_lower(500, 4, 5, 7);
  const Eigen::SimplicialLDLT<Matrix> eigen(lower);
  const Eigen::VectorXd x = LdlFactor(lower, {}).solve(ramp(500)), expected = eigen.solve(ramp(500));
  CHECK((x.array() == expected.array()).all());
}

TEST_CASE("a matrix with an empty row is not regular; one without rows is") {
  Matrix lower = random_lower(10, 2, 4, 3);
  lower.prune([](Eigen::Index row, Eigen::Index column, double) { return row != 4 && column != 4; });
  CHECK_FALSE(LdlFactor(lower, {}).is_regular());
  CHECK(LdlFactor(Matrix(0, 0), {}).is_regular());
}

TEST_CASE("a factorization can be stopped") {
  const std::atomic<bool> stop{true};
  Run run;
  run.stop = &stop;
  CHECK_THROWS_AS(LdlFactor(random_lower(10, 2, 4, 3), run), Error);
}

}  // namespace rimline
