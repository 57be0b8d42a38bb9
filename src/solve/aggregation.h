// SPDX-License-Identifier: GPL-3.0-or-later
// A solver for convex combinations whose neighbours are not mutual, as in eq. (4): matrices that are weakly
// diagonally dominant by rows, not symmetric, and nearly singular where a short loop holds many points.
// After Notay 2012, "Aggregation-based algebraic multigrid for convection-diffusion equations".
#pragma once

#include <memory>
#include <vector>

#include "rimline/run.h"
#include "solve/row_matrix.h"

namespace rimline {

// A hierarchy of ever smaller matrices, each the sums of the former over groups of rows and columns. These
// stay diagonally dominant, whatever the weights are, which smoother prolongations do not promise here; the
// slower cycle is made up for by two steps of generalized conjugate residuals on every level (the K-cycle).
class AggregationMultigrid {
 public:
  // The matrix: positive diagonal, no positive entry beside it, row sums not negative, and from each row a
  // chain of entries to a row with a positive sum.
  AggregationMultigrid(RowMatrix matrix, const Run& run);
  ~AggregationMultigrid();

  // The matrix as it was given, but for its rows, which are multiplied by row_scale().
  const RowMatrix& matrix() const;
  const std::vector<double>& row_scale() const { return row_scale_; }
  int levels() const { return static_cast<int>(levels_.size()); }
  // One cycle from zero: x ~ A^-1 b, A and b with their rows multiplied by row_scale(). Not a linear
  // operator: the steps depend on b.
  void precondition(const std::vector<UV>& b, std::vector<UV>& x);

 private:
  struct Level;
  struct Coarsest;

  bool coarsen();
  void solve_level(std::size_t at);
  void cycle(std::size_t at, const UV* b, UV* x);

  std::vector<double> row_scale_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::unique_ptr<Coarsest> coarsest_;
  const Run& run_;
};

struct ConvexSolve {
  int iterations = 0;
  double residual = 0;  // |b - A x| / |b|, the larger of the two columns, computed from x at the end
};

// Solves A x = b from the x given, A being the multigrid's matrix with row i divided by scale[i] > 0 (b and
// the residual are measured so), until both columns have a relative residual of at most `tolerance` or
// `max_iterations` are done. The sums run in a fixed order: the bytes of x do not depend on threads.
ConvexSolve solve(AggregationMultigrid& multigrid, const std::vector<double>& scale, const std::vector<UV>& b,
                  double tolerance, int max_iterations, std::vector<UV>& x, const Run& run);

}  // namespace rimline
