// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/multigrid.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "base/prefault.h"
#include "solve/blocks.h"
#include "solve/sweeps.h"

namespace rimline {
namespace {

constexpr Index coarsest_size = 300;  // small enough for a dense factor: 9 million operations
constexpr double strong = 0.08;       // of sqrt(a_ii a_jj), halved on each level (Vanek et al., section 5.1)

// Rows of a matrix that blocks of rows have found side by side.
struct Part {
  std::vector<Index> columns;
  std::vector<double> values;
};

// One after another in two arrays.
void put_together(const std::vector<Part>& parts, std::vector<Index>& columns, std::vector<double>& values,
                  const Run& run) {
  std::vector<std::size_t> start{0};
  for (const Part& part : parts) start.push_back(start.back() + part.columns.size());
  resize_together(columns, start.back(), run);
  resize_together(values, start.back(), run);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    std::ranges::copy(parts[k].columns, columns.begin() + static_cast<std::ptrdiff_t>(start[k]));
    std::ranges::copy(parts[k].values, values.begin() + static_cast<std::ptrdiff_t>(start[k]));
  });
}

bool is_strong(const SymmetricMatrix& a, Index i, Index e, double threshold) {
  const double v = a.values[e];
  return v < 0 && v * v > threshold * threshold * a.diagonal[i] * a.diagonal[a.columns[e]];
}

}  // namespace

Multigrid::Multigrid(SymmetricMatrix matrix, const Run& run) : run_(run) {
  levels_.emplace_back();
  levels_.back().matrix = std::move(matrix);
  Arena arena(run);
  arena.execute([&] {
    while (coarsen()) run_.check_cancel();
  });
  for (Level& level : levels_) {
    const Index n = level.matrix.size();
    resize_together(level.inverse_diagonal, n, run);
    arena.execute(
        [&] { for_each_row(n, [&](Index i) { level.inverse_diagonal[i] = 1 / level.matrix.diagonal[i]; }); });
    for (std::vector<UV>* vector : {&level.b, &level.x, &level.residual}) resize_together(*vector, n, run);
  }
  if (levels_.back().matrix.size() <= 4 * coarsest_size) factorize_coarsest();
}

double Multigrid::operator_complexity() const {
  double all = 0;
  for (const Level& level : levels_)
    all += static_cast<double>(level.matrix.values.size() + level.matrix.diagonal.size());
  return all / static_cast<double>(matrix().values.size() + matrix().diagonal.size());
}

// Adds a coarser level. False when the last one is small enough, or no longer shrinks.
bool Multigrid::coarsen() {
  Level& fine = levels_.back();
  const Index n = fine.matrix.size();
  if (n <= coarsest_size) return false;
  const double threshold = strong * std::pow(0.5, static_cast<double>(levels_.size() - 1));
  Index coarse_size = 0;
  const std::vector<Index> aggregates = aggregate(fine.matrix, threshold, coarse_size);
  if (coarse_size == 0 || coarse_size > 0.8 * n) return false;
  run_.check_cancel();
  fine.up = smooth(fine.matrix, aggregates, threshold);
  run_.check_cancel();
  fine.down = transpose(fine.up, coarse_size);
  run_.check_cancel();
  SymmetricMatrix coarse = galerkin(fine, coarse_size);
  levels_.emplace_back();  // invalidates `fine`
  levels_.back().matrix = std::move(coarse);
  return true;
}

// Each row's aggregate, or none for a row without strong neighbours, which smoothing alone settles. First
// whole neighbourhoods, then the rows beside them, then what is left.
std::vector<Index> Multigrid::aggregate(const SymmetricMatrix& a, double threshold, Index& count) const {
  constexpr Index open = -2;
  std::vector<Index> aggregates(a.size(), none);
  std::vector<char> strong_entry(a.values.size());
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
        strong_entry[e] = is_strong(a, i, e, threshold);
        if (strong_entry[e]) aggregates[i] = open;
      }
    }
  });
  const auto claim = [&](Index i) {
    aggregates[i] = count;
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
      if (strong_entry[e] && aggregates[a.columns[e]] == open) aggregates[a.columns[e]] = count;
    }
    ++count;
  };
  count = 0;
  for (Index i = 0; i < a.size(); ++i) {
    bool free = aggregates[i] == open;
    for (Index e = a.offsets[i]; free && e < a.offsets[i + 1]; ++e)
      free = !strong_entry[e] || aggregates[a.columns[e]] == open;
    if (free) claim(i);
  }
  run_.check_cancel();
  const std::vector<Index> first = aggregates;
  for_each_row(a.size(), [&](Index i) {
    double strongest = 0;
    for (Index e = a.offsets[i]; first[i] == open && e < a.offsets[i + 1]; ++e) {
      if (strong_entry[e] && first[a.columns[e]] >= 0 && -a.values[e] > strongest) {
        strongest = -a.values[e];
        aggregates[i] = first[a.columns[e]];
      }
    }
  });
  for (Index i = 0; i < a.size(); ++i) {
    if (aggregates[i] == open) claim(i);
  }
  return aggregates;
}

// P = (I - w D^-1 A) T, T the aggregates' indicator. Weak entries of A count to its diagonal. w = 0.9,
// by trial (docs/lab); the spectrum of D^-1 A reaches at most 2, so that any w below 1 damps.
Multigrid::Prolongation Multigrid::smooth(const SymmetricMatrix& a, const std::vector<Index>& aggregates,
                                          double threshold) const {
  constexpr double omega = 0.9;
  const Index n = a.size();
  std::vector<Part> parts(block_count(n));
  Prolongation p;
  p.offsets.assign(n + 1, 0);
  for_each_block(n, [&](Index block, Index begin, Index end) {
    Part& part = parts[block];
    std::vector<std::pair<Index, double>> row;
    const auto add = [&](Index column, double value) {
      if (column == none) return;
      for (auto& [c, v] : row) {
        if (c == column) {
          v += value;
          return;
        }
      }
      row.emplace_back(column, value);
    };
    for (Index i = begin; i < end; ++i) {
      double diagonal = a.diagonal[i];
      for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
        if (!is_strong(a, i, e, threshold)) diagonal += a.values[e];
      }
      row.clear();
      if (diagonal > 0) {
        add(aggregates[i], 1 - omega);
        for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
          if (is_strong(a, i, e, threshold)) add(aggregates[a.columns[e]], -omega * a.values[e] / diagonal);
        }
      } else {
        add(aggregates[i], 1);
      }
      std::sort(row.begin(), row.end());
      for (const auto& [column, value] : row) {
        part.columns.push_back(column);
        part.values.push_back(value);
      }
      p.offsets[i + 1] = static_cast<Index>(row.size());
    }
  });
  for (Index i = 0; i < n; ++i) p.offsets[i + 1] += p.offsets[i];
  put_together(parts, p.columns, p.values, run_);
  return p;
}

Multigrid::Prolongation Multigrid::transpose(const Prolongation& p, Index columns) {
  Prolongation t;
  t.offsets.assign(columns + 1, 0);
  t.columns.resize(p.columns.size());
  t.values.resize(p.values.size());
  for (const Index c : p.columns) ++t.offsets[c + 1];
  for (Index c = 0; c < columns; ++c) t.offsets[c + 1] += t.offsets[c];
  std::vector<Index> at(t.offsets.begin(), t.offsets.end() - 1);
  for (Index i = 0; i + 1 < static_cast<Index>(p.offsets.size()); ++i) {
    for (Index e = p.offsets[i]; e < p.offsets[i + 1]; ++e) {
      t.columns[at[p.columns[e]]] = i;
      t.values[at[p.columns[e]]++] = p.values[e];
    }
  }
  return t;
}

// P' A P, one coarse row at a time.
SymmetricMatrix Multigrid::galerkin(const Level& fine, Index coarse_size) const {
  const SymmetricMatrix& a = fine.matrix;
  SymmetricMatrix coarse;
  coarse.diagonal.resize(coarse_size);
  coarse.offsets.assign(coarse_size + 1, 0);
  constexpr Index rows = 1024;  // coarse rows of one task: each gathers some 20 fine ones
  std::vector<Part> parts((coarse_size + rows - 1) / rows);
  tbb::enumerable_thread_specific<std::vector<double>> sums(
      [&] { return std::vector<double>(coarse_size, 0.0); });
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    std::vector<double>& sum = sums.local();
    std::vector<Index> touched;
    const auto scatter = [&](Index j, double weight) {
      for (Index f = fine.up.offsets[j]; f < fine.up.offsets[j + 1]; ++f) {
        const Index column = fine.up.columns[f];
        if (sum[column] == 0) touched.push_back(column);
        sum[column] += weight * fine.up.values[f];
      }
    };
    for (Index i = static_cast<Index>(k) * rows; i < std::min<Index>(coarse_size, (k + 1) * rows); ++i) {
      touched.clear();
      for (Index d = fine.down.offsets[i]; d < fine.down.offsets[i + 1]; ++d) {
        const Index row = fine.down.columns[d];
        const double weight = fine.down.values[d];
        scatter(row, weight * a.diagonal[row]);
        for (Index e = a.offsets[row]; e < a.offsets[row + 1]; ++e)
          scatter(a.columns[e], weight * a.values[e]);
      }
      std::sort(touched.begin(), touched.end());
      for (std::size_t t = 0; t < touched.size(); ++t) {
        const Index column = touched[t];
        if (t > 0 && touched[t - 1] == column) continue;  // its sum was temporarily 0
        if (column == i) {
          coarse.diagonal[i] = sum[column];
        } else if (sum[column] != 0) {
          parts[k].columns.push_back(column);
          parts[k].values.push_back(sum[column]);
          ++coarse.offsets[i + 1];
        }
      }
      for (const Index column : touched) sum[column] = 0;
    }
  });
  for (Index i = 0; i < coarse_size; ++i) coarse.offsets[i + 1] += coarse.offsets[i];
  put_together(parts, coarse.columns, coarse.values, run_);
  return coarse;
}

void Multigrid::factorize_coarsest() {
  const SymmetricMatrix& a = levels_.back().matrix;
  const std::size_t n = a.diagonal.size();
  factor_.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    double* row = &factor_[i * n];
    row[i] = a.diagonal[i];
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
      if (a.columns[e] < static_cast<Index>(i)) row[a.columns[e]] = a.values[e];
    }
    for (std::size_t j = 0; j <= i; ++j) {
      const double* other = &factor_[j * n];
      double sum = row[j];
      for (std::size_t m = 0; m < j; ++m) sum -= row[m] * other[m];
      // A pivot that rounding made worthless: leave the unknown to the finer levels.
      row[j] = j < i ? sum / other[j] : std::sqrt(std::max(sum, 1e-14 * a.diagonal[i]));
    }
  }
}

void Multigrid::solve_coarsest(const UV* b, UV* x) const {
  const SymmetricMatrix& a = levels_.back().matrix;
  const std::size_t n = a.diagonal.size();
  if (factor_.empty()) {  // without coarsening: a diagonal step keeps the cycle symmetric
    for (std::size_t i = 0; i < n; ++i) x[i] = levels_.back().inverse_diagonal[i] * b[i];
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    UV sum = b[i];
    for (std::size_t j = 0; j < i; ++j) sum = sum - factor_[i * n + j] * x[j];
    x[i] = (1 / factor_[i * n + i]) * sum;
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] = (1 / factor_[i * n + i]) * x[i];
    for (std::size_t j = 0; j < i; ++j) x[j] = x[j] - factor_[i * n + j] * x[i];
  }
}

void Multigrid::cycle(std::size_t at, const UV* b, UV* x) {
  if (at + 1 == levels_.size()) return solve_coarsest(b, x);
  Level& level = levels_[at];
  Level& coarse = levels_[at + 1];
  UV* r = level.residual.data();
  sweep_forward(level.matrix, level.inverse_diagonal, b, x);
  residual_after_forward(level.matrix, x, r);
  const auto apply = [](const Prolongation& p, Index row, const UV* in) {
    UV sum;
    for (Index e = p.offsets[row]; e < p.offsets[row + 1]; ++e) sum = sum + p.values[e] * in[p.columns[e]];
    return sum;
  };
  for_each_block(coarse.matrix.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) coarse.b[i] = apply(level.down, i, r);
  });
  cycle(at + 1, coarse.b.data(), coarse.x.data());
  for_each_block(level.matrix.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) x[i] = x[i] + apply(level.up, i, coarse.x.data());
  });
  sweep_backward(level.matrix, level.inverse_diagonal, b, r, x);
}

void Multigrid::precondition(const std::vector<UV>& b, std::vector<UV>& x) { cycle(0, b.data(), x.data()); }

SolveResult solve(Multigrid& multigrid, const std::vector<UV>& b, double tolerance, int max_iterations,
                  std::vector<UV>& x, const Run& run) {
  const SymmetricMatrix& a = multigrid.matrix();
  const Index n = a.size();
  std::vector<UV> r, z, p, q;
  for (std::vector<UV>* vector : {&r, &z, &p, &q}) resize_together(*vector, n, run);
  const auto product = [](UV s, UV t) { return UV{s.u * t.u, s.v * t.v}; };
  const auto quotient = [](UV s, UV t) { return UV{t.u > 0 ? s.u / t.u : 0, t.v > 0 ? s.v / t.v : 0}; };
  const UV size = sum_of(n, [&](Index i) { return product(b[i], b[i]); });
  const auto relative = [&](UV rr) {
    const UV ratio = {size.u > 0 ? rr.u / size.u : rr.u, size.v > 0 ? rr.v / size.v : rr.v};
    return std::sqrt(std::max(ratio.u, ratio.v));
  };
  SolveResult result;
  Arena arena(run);
  arena.execute([&] {
    compute_residual(a, b.data(), x.data(), r.data());
    run.check_cancel();
    UV rr = sum_of(n, [&](Index i) { return product(r[i], r[i]); });
    UV rz;
    while (relative(rr) > tolerance && result.iterations < max_iterations) {
      run.check_cancel();
      multigrid.precondition(r, z);
      const UV next = sum_of(n, [&](Index i) { return product(r[i], z[i]); });
      const UV beta = quotient(next, rz);
      rz = next;
      for_each_block(n, [&](Index, Index begin, Index end) {
        for (Index i = begin; i < end; ++i) p[i] = z[i] + product(beta, p[i]);
      });
      const UV pq = sum_of(n, [&](Index i) {
        q[i] = a.diagonal[i] * p[i] + a.off_diagonal(i, p.data());
        return product(p[i], q[i]);
      });
      const UV alpha = quotient(rz, pq);
      rr = sum_of(n, [&](Index i) {
        x[i] = x[i] + product(alpha, p[i]);
        r[i] = r[i] - product(alpha, q[i]);
        return product(r[i], r[i]);
      });
      ++result.iterations;
    }
    compute_residual(a, b.data(), x.data(), r.data());
    rr = sum_of(n, [&](Index i) { return product(r[i], r[i]); });
    result.residual = relative(rr);
  });
  return result;
}

}  // namespace rimline
