// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse symmetric matrix as L D L', by a factorization that can be stopped: of a million unknowns it takes
// half a minute, and Eigen's SimplicialLDLT, which gives the same numbers, runs to its end once begun.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "rimline/run.h"

namespace rimline {

class LdlFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  // Of a matrix given by its lower triangle, in the order of approximate minimum degree.
  LdlFactor(const Matrix& lower, const Run& run);

  // False where a pivot is zero: nothing can be solved then.
  bool is_regular() const { return is_regular_; }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  void count_entries();
  void factorize(const Run& run);

  Eigen::PermutationMatrix<Eigen::Dynamic> order_;
  Matrix upper_;             // of the matrix in that order
  std::vector<int> parent_;  // in the elimination tree, -1 at its roots
  // L without its diagonal of ones, by columns; D.
  std::vector<std::size_t> start_;
  std::vector<int> rows_;
  std::vector<double> values_, diagonal_;
  bool is_regular_ = true;
};

}  // namespace rimline
