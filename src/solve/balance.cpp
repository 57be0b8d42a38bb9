// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/balance.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solve/blocks.h"
#include "solve/groups.h"

namespace rimline {
namespace {

constexpr Index coarsest_size = 200;  // small enough for dense elimination: 8 million operations
constexpr int most_levels = 40;

// The flow into each row from other rows, and the flow out of it.
struct Inflow {
  RowMatrix from;  // the diagonal is what leaves
};

Inflow inflow_of(const RowMatrix& rates) {
  const Index n = rates.size();
  Inflow in;
  RowMatrix& t = in.from;
  t.diagonal.assign(n, 0);
  t.offsets.assign(n + 1, 0);
  t.columns.resize(rates.columns.size());
  t.values.resize(rates.values.size());
  for (const Index c : rates.columns) ++t.offsets[c + 1];
  for (Index c = 0; c < n; ++c) t.offsets[c + 1] += t.offsets[c];
  std::vector<Index> at(t.offsets.begin(), t.offsets.end() - 1);
  for (Index i = 0; i < n; ++i) {
    for (Index e = rates.offsets[i]; e < rates.offsets[i + 1]; ++e) {
      const Index to = at[rates.columns[e]]++;
      t.columns[to] = i;
      t.values[to] = -rates.values[e];
      t.diagonal[i] -= rates.values[e];
    }
  }
  return in;
}

void normalize(std::vector<double>& visits) {
  const double mean = std::accumulate(visits.begin(), visits.end(), 0.0) / static_cast<double>(visits.size());
  // Rows that no row lists are never visited; no factor may be zero.
  constexpr double least = 1e-12;
  for (double& v : visits) v = std::max(v / mean, least);
}

// One sweep of v_j = (what flows in) / (what leaves), Gauss-Seidel inside each block.
void relax(const Inflow& in, std::vector<double>& visits) {
  const RowMatrix& t = in.from;
  const std::vector<double> old = visits;
  for_each_block(t.size(), [&](Index, Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
      double sum = 0;
      for (Index e = t.offsets[j]; e < t.offsets[j + 1]; ++e) {
        const Index i = t.columns[e];
        sum += t.values[e] * (i >= begin && i < end ? visits : old)[i];
      }
      if (t.diagonal[j] > 0) visits[j] = sum / t.diagonal[j];
    }
  });
  normalize(visits);
}

// Grassmann, Taksar & Heyman 1985: elimination without a subtraction.
std::vector<double> eliminate(const RowMatrix& rates) {
  const std::size_t n = rates.size();
  std::vector<double> p(n * n, 0), visits(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (Index e = rates.offsets[i]; e < rates.offsets[i + 1]; ++e)
      p[i * n + rates.columns[e]] -= rates.values[e];
  }
  for (std::size_t k = n; k-- > 1;) {
    const double leaves = std::accumulate(&p[k * n], &p[k * n + k], 0.0);
    if (!(leaves > 0)) continue;
    for (std::size_t i = 0; i < k; ++i) {
      const double share = p[i * n + k] /= leaves;
      for (std::size_t j = 0; share > 0 && j < k; ++j) p[i * n + j] += share * p[k * n + j];
    }
  }
  visits[0] = 1;
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) visits[k] += visits[i] * p[i * n + k];
  }
  normalize(visits);
  return visits;
}

std::vector<double> stationary(const RowMatrix& rates, int level, const Run& run) {
  constexpr int sweeps = 2;
  run.check_cancel();
  const Index n = rates.size();
  if (n <= coarsest_size) return eliminate(rates);
  const Inflow in = inflow_of(rates);
  std::vector<double> visits(n, 1.0);
  for (int i = 0; i < sweeps; ++i) relax(in, visits);
  const int rounds = level == 0 ? 3 : level < 3 ? 2 : 1;
  for (int round = 0; round < rounds && level < most_levels; ++round) {
    RowMatrix flow = rates;
    scale_rows(flow, visits);
    const Grouping grouping = group_rows(flow);
    if (grouping.groups.count() > 0.8 * n) break;
    const std::vector<double> coarse = stationary(grouping.sums, level + 1, run);
    for (Index i = 0; i < n; ++i) visits[i] *= coarse[grouping.groups.of[i]];
    for (int i = 0; i < sweeps; ++i) relax(in, visits);
  }
  return visits;
}

}  // namespace

std::vector<double> balancing_rows(const RowMatrix& rates, const Run& run) {
  return stationary(rates, 0, run);
}

void scale_rows(RowMatrix& matrix, const std::vector<double>& factors) {
  for_each_row(matrix.size(), [&](Index i) {
    matrix.diagonal[i] *= factors[i];
    for (Index e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e) matrix.values[e] *= factors[i];
  });
}

}  // namespace rimline
