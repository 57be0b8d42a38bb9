// SPDX-License-Identifier: GPL-3.0-or-later
// Davis, Direct Methods for Sparse Linear Systems, chapter 4: row k of L solves a triangular system with the
// rows above it; its pattern is what the entries of column k reach in the elimination tree.
#include "solve/ldl.h"

#include <Eigen/OrderingMethods>
#include <numeric>

namespace rimline {
namespace {

constexpr std::size_t entries_per_look = std::size_t{1} << 22;  // between two looks at the stop flag

}  // namespace

LdlFactor::LdlFactor(const Matrix& lower, const Run& run) {
  Eigen::PermutationMatrix<Eigen::Dynamic> inverse;
  const Matrix whole = lower.selfadjointView<Eigen::Lower>();
  run.check_cancel();
  Eigen::AMDOrdering<int>()(whole, inverse);
  run.check_cancel();
  order_ = inverse.inverse();
  upper_.resize(lower.rows(), lower.cols());
  upper_.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
  run.check_cancel();
  count_entries();
  run.check_cancel();
  factorize(run);
  upper_ = Matrix();
}

// The elimination tree, and where each column of L begins.
void LdlFactor::count_entries() {
  const auto size = static_cast<int>(upper_.cols());
  parent_.assign(size, -1);
  start_.assign(size + 1, 0);
  std::vector<int> reached(size, -1);
  for (int k = 0; k < size; ++k) {
    reached[k] = k;
    for (Matrix::InnerIterator entry(upper_, k); entry; ++entry) {
      for (auto i = static_cast<int>(entry.index()); i < k && reached[i] != k; i = parent_[i]) {
        if (parent_[i] == -1) parent_[i] = k;
        ++start_[i + 1];
        reached[i] = k;
      }
    }
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
}

void LdlFactor::factorize(const Run& run) {
  const auto size = static_cast<int>(upper_.cols());
  rows_.resize(start_.back());
  values_.resize(start_.back());
  diagonal_.resize(size);
  std::vector<int> reached(size, -1), pattern(size);
  std::vector<std::size_t> end(start_.begin(), start_.end() - 1);
  std::vector<double> row(size, 0);  // row k of L D, and back to zeros
  std::size_t passed = 0;            // entries since the last look
  for (int k = 0; k < size; ++k) {
    int top = size;  // the pattern, each column after those that it depends on, is at the end of `pattern`
    reached[k] = k;
    for (Matrix::InnerIterator entry(upper_, k); entry; ++entry) {
      auto i = static_cast<int>(entry.index());
      row[i] += entry.value();
      int length = 0;
      for (; reached[i] != k; i = parent_[i]) {
        pattern[length++] = i;
        reached[i] = k;
      }
      while (length > 0) pattern[--top] = pattern[--length];
    }
    double pivot = row[k];
    row[k] = 0;
    for (; top < size; ++top) {
      const int i = pattern[top];
      const double value = row[i], entry = value / diagonal_[i];
      row[i] = 0;
      for (std::size_t e = start_[i]; e < end[i]; ++e) row[rows_[e]] -= values_[e] * value;
      passed += end[i] - start_[i];
      if (passed > entries_per_look) {
        run.check_cancel();
        passed = 0;
      }
      pivot -= entry * value;
      rows_[end[i]] = k;
      values_[end[i]++] = entry;
    }
    diagonal_[k] = pivot;
    if (pivot == 0) {
      is_regular_ = false;
      return;
    }
  }
}

Eigen::VectorXd LdlFactor::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd x = order_ * right;
  const auto size = static_cast<int>(x.size());
  for (int i = 0; i < size; ++i) {
    for (std::size_t e = start_[i]; e < start_[i + 1]; ++e) x[rows_[e]] -= values_[e] * x[i];
  }
  for (int i = 0; i < size; ++i) x[i] *= 1 / diagonal_[i];
  for (int i = size; i-- > 0;) {
    for (std::size_t e = start_[i]; e < start_[i + 1]; ++e) x[i] -= values_[e] * x[rows_[e]];
  }
  return order_.transpose() * x;
}

}  // namespace rimline
