// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients with a smoothed aggregation multigrid as preconditioner, for the Laplacians of the map.
// Vanek, Mandel, Brezina 1996, "Algebraic multigrid by smoothed aggregation for second and fourth order
// elliptic problems".
#pragma once

#include <span>
#include <vector>

#include "rimline/run.h"
#include "solve/sparse.h"

namespace rimline {

// A hierarchy of ever smaller matrices for a symmetric, weakly diagonally dominant matrix with positive
// diagonal whose off-diagonal entries are not positive.
class Multigrid {
 public:
  Multigrid(SymmetricMatrix matrix, const Run& run);

  const SymmetricMatrix& matrix() const { return levels_.front().matrix; }
  // One symmetric V-cycle from zero: x ~ A^-1 b, a fixed positive definite operator.
  void precondition(const std::vector<UV>& b, std::vector<UV>& x);
  int levels() const { return static_cast<int>(levels_.size()); }
  // Stored entries of all levels over those of the finest.
  double operator_complexity() const;

 private:
  struct Prolongation {  // rows of the finer level, columns of the coarser
    std::vector<Index> offsets, columns;
    std::vector<double> values;
  };
  struct Level {
    SymmetricMatrix matrix;
    std::vector<double> inverse_diagonal;
    Prolongation up, down;           // to and from the next coarser level: transposes of each other
    std::vector<UV> b, x, residual;  // work space
  };

  void cycle(std::size_t at, const UV* b, UV* x);
  void factorize_coarsest();
  void solve_coarsest(const UV* b, UV* x) const;
  bool coarsen();
  std::vector<Index> aggregate(const SymmetricMatrix& a, double threshold, Index& count) const;
  Prolongation smooth(const SymmetricMatrix& a, const std::vector<Index>& aggregates, double threshold) const;
  static Prolongation transpose(const Prolongation& p, Index columns);
  SymmetricMatrix galerkin(const Level& fine, Index coarse_size) const;

  std::vector<Level> levels_;
  std::vector<double> factor_;  // of the coarsest matrix: lower Cholesky factor, row after row
  const Run& run_;
};

struct SolveResult {
  int iterations = 0;
  double residual = 0;  // |b - A x| / |b|, the larger of the two columns, computed from x at the end
};

// Solves A x = b from the x given until both columns have a relative residual of at most `tolerance`, or
// `max_iterations` are done. The sums run in a fixed order: the bytes of x do not depend on threads.
SolveResult solve(Multigrid& multigrid, const std::vector<UV>& b, double tolerance, int max_iterations,
                  std::vector<UV>& x, const Run& run);

}  // namespace rimline
