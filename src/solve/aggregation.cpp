// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/aggregation.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "solve/balance.h"
#include "solve/blocks.h"
#include "solve/groups.h"

namespace rimline {
namespace {

constexpr Index coarsest_size = 1000;  // its factors fit a second-level cache
constexpr int most_levels = 40;        // far beyond what any number of rows needs

UV operator*(UV a, UV b) { return {a.u * b.u, a.v * b.v}; }
// a / b, and 0 for a column that is solved already.
UV ratio(UV a, UV b) { return {b.u != 0 ? a.u / b.u : 0, b.v != 0 ? a.v / b.v : 0}; }

// One forward Gauss-Seidel sweep inside each block from x = 0.
void sweep_forward(const RowMatrix& a, const UV* b, UV* x) {
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      UV sum = b[i];
      for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
        const Index j = a.columns[e];
        if (j >= begin && j < i) sum = sum - a.values[e] * x[j];
      }
      x[i] = (1 / a.diagonal[i]) * sum;
    }
  });
}

// One backward sweep inside each block. What lies outside is read as it was before, from `old`.
void sweep_backward(const RowMatrix& a, const UV* b, UV* old, UV* x) {
  for_each_row(a.size(), [&](Index i) { old[i] = x[i]; });
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = end - 1; i >= begin; --i) {
      UV sum = b[i];
      for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
        const Index j = a.columns[e];
        sum = sum - a.values[e] * (j >= begin && j < end ? x : old)[j];
      }
      x[i] = (1 / a.diagonal[i]) * sum;
    }
  });
}

}  // namespace

struct AggregationMultigrid::Level {
  explicit Level(RowMatrix a)
      : matrix(std::move(a)), b(matrix.size()), x(b), residual(b), first(b), first_image(b), image(b) {}

  RowMatrix matrix;
  Groups groups;         // its rows in the next coarser level
  std::vector<UV> b, x;  // what is to be solved on this level, and the solution
  std::vector<UV> residual, first, first_image, image;  // work space
};

struct AggregationMultigrid::Coarsest {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
  bool solved = false;
};

AggregationMultigrid::AggregationMultigrid(RowMatrix matrix, const Run& run)
    : coarsest_(std::make_unique<Coarsest>()), run_(run) {
  Arena arena(run);
  arena.execute([&] {
    row_scale_ = balancing_rows(matrix, run);
    scale_rows(matrix, row_scale_);
    levels_.push_back(std::make_unique<Level>(std::move(matrix)));
    while (levels() < most_levels && coarsen()) run_.check_cancel();
  });
  const RowMatrix& a = levels_.back()->matrix;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < a.size(); ++i) {
    entries.emplace_back(i, i, a.diagonal[i]);
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e)
      entries.emplace_back(i, a.columns[e], a.values[e]);
  }
  Eigen::SparseMatrix<double> sparse(a.size(), a.size());
  sparse.setFromTriplets(entries.begin(), entries.end());
  coarsest_->factors.compute(sparse);
  coarsest_->solved = coarsest_->factors.info() == Eigen::Success;
}

AggregationMultigrid::~AggregationMultigrid() = default;

const RowMatrix& AggregationMultigrid::matrix() const { return levels_.front()->matrix; }

// Adds a coarser level, of groups of about four rows. False when the last one is small enough or does not
// shrink.
bool AggregationMultigrid::coarsen() {
  Level& fine = *levels_.back();
  const Index n = fine.matrix.size();
  if (n <= coarsest_size) return false;
  Grouping grouping = group_rows(fine.matrix);
  run_.check_cancel();
  if (grouping.groups.count() > 0.8 * n) return false;
  fine.groups = std::move(grouping.groups);
  levels_.push_back(std::make_unique<Level>(std::move(grouping.sums)));
  return true;
}

void AggregationMultigrid::cycle(std::size_t at, const UV* b, UV* x) {
  Level& level = *levels_[at];
  const Index n = level.matrix.size();
  if (at + 1 == levels_.size()) {
    if (!coarsest_->solved) return sweep_forward(level.matrix, b, x);
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
    const Eigen::MatrixXd right = Eigen::Map<const Columns>(&b->u, n, 2);
    const Eigen::MatrixXd solution = coarsest_->factors.solve(right);
    for (Index i = 0; i < n; ++i) x[i] = {solution(i, 0), solution(i, 1)};
    return;
  }
  Level& coarse = *levels_[at + 1];
  std::vector<UV>& rest = level.image;
  sweep_forward(level.matrix, b, x);
  for_each_row(n, [&](Index i) { rest[i] = b[i] - level.matrix.times(i, x); });
  for_each_row(coarse.matrix.size(), [&](Index g) {
    UV sum;
    for (Index m = level.groups.offsets[g]; m < level.groups.offsets[g + 1]; ++m)
      sum = sum + rest[level.groups.members[m]];
    coarse.b[g] = sum;
  });
  solve_level(at + 1);
  for_each_row(n, [&](Index i) { x[i] = x[i] + coarse.x[level.groups.of[i]]; });
  sweep_backward(level.matrix, b, rest.data(), x);
}

// A level's x from its b: at most two steps of generalized conjugate residuals, each with a cycle. The
// second is left out where the first was good (Notay 2012, section 4).
void AggregationMultigrid::solve_level(std::size_t at) {
  Level& level = *levels_[at];
  const Index n = level.matrix.size();
  run_.check_cancel();
  if (at + 1 == levels_.size()) return cycle(at, level.b.data(), level.x.data());
  std::vector<UV>&c1 = level.first, &v1 = level.first_image, &r = level.residual, &c2 = level.x;
  cycle(at, level.b.data(), c1.data());
  for_each_row(n, [&](Index i) { v1[i] = level.matrix.times(i, c1.data()); });
  const UV norm1 = sum_of(n, [&](Index i) { return v1[i] * v1[i]; });
  const UV a1 = ratio(sum_of(n, [&](Index i) { return v1[i] * level.b[i]; }), norm1);
  for_each_row(n, [&](Index i) { r[i] = level.b[i] - a1 * v1[i]; });
  const UV before = sum_of(n, [&](Index i) { return level.b[i] * level.b[i]; });
  const UV after = sum_of(n, [&](Index i) { return r[i] * r[i]; });
  constexpr double good = 0.25 * 0.25;
  if (after.u <= good * before.u && after.v <= good * before.v) {
    for_each_row(n, [&](Index i) { level.x[i] = a1 * c1[i]; });
    return;
  }
  cycle(at, r.data(), c2.data());
  std::vector<UV>& v2 = level.image;
  for_each_row(n, [&](Index i) { v2[i] = level.matrix.times(i, c2.data()); });
  const UV mixed = ratio(sum_of(n, [&](Index i) { return v2[i] * v1[i]; }), norm1);
  for_each_row(n, [&](Index i) { v2[i] = v2[i] - mixed * v1[i]; });
  const UV norm2 = sum_of(n, [&](Index i) { return v2[i] * v2[i]; });
  const UV a2 = ratio(sum_of(n, [&](Index i) { return v2[i] * r[i]; }), norm2);
  for_each_row(n, [&](Index i) { level.x[i] = (a1 - a2 * mixed) * c1[i] + a2 * c2[i]; });
}

void AggregationMultigrid::precondition(const std::vector<UV>& b, std::vector<UV>& x) {
  cycle(0, b.data(), x.data());
}

namespace {

// A direction of the outer iteration and what the matrix makes of it.
struct Direction {
  std::vector<UV> step, image;
  UV norm;  // squared, of the image
};

// Generalized conjugate residuals, restarted; each step is preconditioned by one cycle.
class ConjugateResiduals {
 public:
  ConjugateResiduals(AggregationMultigrid& multigrid, const std::vector<double>& scale,
                     const std::vector<UV>& b, std::vector<UV>& x)
      : multigrid_(multigrid),
        scale_(scale),
        b_(b),
        x_(x),
        n_(multigrid.matrix().size()),
        r_(n_),
        scaled_(n_) {
    for (Index i = 0; i < n_; ++i) scale_[i] *= multigrid.row_scale()[i];
    size_ = sum_of(n_, [&](Index i) { return b[i] * b[i]; });
    measure();
  }

  // Relative, as the recurrence has it; measure() computes it from x.
  double residual() const { return residual_; }
  void measure() {
    residual_ = relative(sum_of(n_, [&](Index i) {
      r_[i] = b_[i] - image(i, x_);
      return r_[i] * r_[i];
    }));
  }
  void restart() { used_ = 0; }
  bool full() const { return used_ == most_directions; }

  // False where nothing new is left to add to the directions.
  bool step() {
    if (used_ == directions_.size()) directions_.push_back({std::vector<UV>(n_), std::vector<UV>(n_), {}});
    Direction& d = directions_[used_];
    for_each_row(n_, [&](Index i) { scaled_[i] = scale_[i] * r_[i]; });
    multigrid_.precondition(scaled_, d.step);
    for_each_row(n_, [&](Index i) { d.image[i] = image(i, d.step); });
    const UV whole = squared(d.image);
    for (std::size_t k = 0; k < used_; ++k) {
      const Direction& old = directions_[k];
      const UV share = ratio(sum_of(n_, [&](Index i) { return d.image[i] * old.image[i]; }), old.norm);
      for_each_row(n_, [&](Index i) {
        d.step[i] = d.step[i] - share * old.step[i];
        d.image[i] = d.image[i] - share * old.image[i];
      });
    }
    d.norm = squared(d.image);
    constexpr double rounding = 1e-20;  // squared: what is left of the direction has no digits any more
    if (!(d.norm.u > rounding * whole.u)) d.norm.u = 0;
    if (!(d.norm.v > rounding * whole.v)) d.norm.v = 0;
    if (d.norm.u == 0 && d.norm.v == 0) return false;
    const UV length = ratio(sum_of(n_, [&](Index i) { return d.image[i] * r_[i]; }), d.norm);
    residual_ = relative(sum_of(n_, [&](Index i) {
      x_[i] = x_[i] + length * d.step[i];
      r_[i] = r_[i] - length * d.image[i];
      return r_[i] * r_[i];
    }));
    ++used_;
    return true;
  }

 private:
  static constexpr std::size_t most_directions = 20;  // kept: more take memory, fewer take iterations

  UV image(Index i, const std::vector<UV>& y) const {
    return (1 / scale_[i]) * multigrid_.matrix().times(i, y.data());
  }
  UV squared(const std::vector<UV>& y) const {
    return sum_of(n_, [&](Index i) { return y[i] * y[i]; });
  }
  double relative(UV squared) const {
    return std::sqrt(
        std::max(squared.u / (size_.u > 0 ? size_.u : 1), squared.v / (size_.v > 0 ? size_.v : 1)));
  }

  AggregationMultigrid& multigrid_;
  std::vector<double> scale_;  // of the rows of the multigrid's matrix
  const std::vector<UV>& b_;
  std::vector<UV>& x_;
  Index n_;
  std::vector<UV> r_, scaled_;
  UV size_;
  double residual_ = 0;
  std::vector<Direction> directions_;
  std::size_t used_ = 0;  // of the directions
};

}  // namespace

ConvexSolve solve(AggregationMultigrid& multigrid, const std::vector<double>& scale, const std::vector<UV>& b,
                  double tolerance, int max_iterations, std::vector<UV>& x, const Run& run) {
  constexpr double stalled = 0.9;  // of the residual at the last restart: more steps would gain nothing
  ConvexSolve result;
  Arena arena(run);
  arena.execute([&] {
    ConjugateResiduals method(multigrid, scale, b, x);
    double before = method.residual();
    while (method.residual() > tolerance && result.iterations < max_iterations) {
      run.progress(Stage::Parameterize, result.iterations, max_iterations);
      const bool moved = method.step();
      ++result.iterations;
      if (moved && !method.full() && method.residual() > tolerance) continue;
      // What the recurrence lost to rounding shows in the true residual only.
      method.measure();
      method.restart();
      if (!(method.residual() < stalled * before)) break;
      before = method.residual();
    }
    method.measure();
    result.residual = method.residual();
  });
  return result;
}

}  // namespace rimline
