// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/graph.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <string>

#include "solve/multigrid.h"

namespace rimline {
namespace {

// The rows of eq. (4), each times the sum of its weights: symmetric. `unknown` numbers the free nodes.
SymmetricMatrix assemble(const Graph& graph, const std::vector<Index>& unknown, const std::vector<UV>& uv,
                         std::vector<UV>& right) {
  SymmetricMatrix a;
  a.columns.reserve(graph.neighbours.size());
  a.values.reserve(graph.neighbours.size());
  for (Index i = 0; i < graph.size(); ++i) {
    if (unknown[i] == none) continue;
    double sum = 0;
    UV fixed;
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      const Index j = graph.neighbours[e];
      sum += graph.weights[e];
      if (unknown[j] == none) {
        fixed = fixed + graph.weights[e] * uv[j];
      } else {
        a.columns.push_back(unknown[j]);
        a.values.push_back(-graph.weights[e]);
      }
    }
    a.diagonal.push_back(sum);
    a.offsets.push_back(static_cast<Index>(a.columns.size()));
    right.push_back(fixed);
  }
  return a;
}

// For systems on which the multigrid stalls.
void solve_directly(const SymmetricMatrix& a, const std::vector<UV>& right, std::vector<UV>& x) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < a.size(); ++i) {
    entries.emplace_back(i, i, a.diagonal[i]);
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
      if (a.columns[e] < i) entries.emplace_back(i, a.columns[e], a.values[e]);
    }
  }
  Eigen::SparseMatrix<double> lower(a.size(), a.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(lower);
  Eigen::MatrixX2d b(a.size(), 2);
  for (Index i = 0; i < a.size(); ++i) b.row(i) << right[i].u, right[i].v;
  const Eigen::MatrixX2d solution = factor.solve(b);
  for (Index i = 0; i < a.size(); ++i) x[i] = {solution(i, 0), solution(i, 1)};
}

struct HalfEdge {
  Index other;
  double weight;
};

// Sorts a short row by id and adds up what names the same node. Equal ids keep their order, so that the sums
// do not depend on the sort. Returns how many entries are left.
Index merge_row(HalfEdge* row, Index count) {
  if (count > 64) {
    std::stable_sort(row, row + count,
                     [](const HalfEdge& a, const HalfEdge& b) { return a.other < b.other; });
  } else {
    for (Index i = 1; i < count; ++i) {
      const HalfEdge moved = row[i];
      Index at = i;
      for (; at > 0 && row[at - 1].other > moved.other; --at) row[at] = row[at - 1];
      row[at] = moved;
    }
  }
  Index used = 0;
  for (Index i = 0; i < count; ++i) {
    if (used > 0 && row[used - 1].other == row[i].other) {
      row[used - 1].weight += row[i].weight;
    } else {
      row[used++] = row[i];
    }
  }
  return used;
}

}  // namespace

Graph make_graph(Index size, const std::vector<WeightedEdge>& edges) {
  std::vector<Index> offsets(size + 1, 0);
  for (const WeightedEdge& e : edges) {
    ++offsets[e.a + 1];
    ++offsets[e.b + 1];
  }
  for (Index i = 0; i < size; ++i) offsets[i + 1] += offsets[i];
  std::vector<HalfEdge> half(offsets[size]);
  std::vector<Index> at(offsets.begin(), offsets.end() - 1);
  for (const WeightedEdge& e : edges) {
    half[at[e.a]++] = {e.b, e.weight};
    half[at[e.b]++] = {e.a, e.weight};
  }
  // Sorted and added up row by row, in place; `used` entries of each row remain.
  std::vector<Index> used(size);
  tbb::parallel_for(tbb::blocked_range<Index>(0, size, 4096), [&](const auto& rows) {
    for (Index i = rows.begin(); i < rows.end(); ++i)
      used[i] = merge_row(&half[offsets[i]], offsets[i + 1] - offsets[i]);
  });
  Graph graph;
  graph.offsets.reserve(size + 1);
  for (Index i = 0; i < size; ++i) graph.offsets.push_back(graph.offsets.back() + used[i]);
  graph.neighbours.resize(graph.offsets[size]);
  graph.weights.resize(graph.offsets[size]);
  tbb::parallel_for(tbb::blocked_range<Index>(0, size, 4096), [&](const auto& rows) {
    for (Index i = rows.begin(); i < rows.end(); ++i) {
      for (Index e = 0; e < used[i]; ++e) {
        graph.neighbours[graph.offsets[i] + e] = half[offsets[i] + e].other;
        graph.weights[graph.offsets[i] + e] = half[offsets[i] + e].weight;
      }
    }
  });
  return graph;
}

std::vector<Index> unreachable(const Graph& graph, const std::vector<char>& fixed) {
  std::vector<char> reached(fixed);
  std::vector<Index> open;
  for (Index i = 0; i < graph.size(); ++i) {
    if (fixed[i]) open.push_back(i);
  }
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      const Index j = graph.neighbours[e];
      if (!reached[j]) open.push_back(j);
      reached[j] = 1;
    }
  }
  std::vector<Index> missed;
  for (Index i = 0; i < graph.size(); ++i) {
    if (!reached[i]) missed.push_back(i);
  }
  return missed;
}

MapSummary solve_map(const Graph& graph, const std::vector<char>& fixed, double tolerance,
                     std::vector<UV>& uv, const Run& run) {
  std::vector<Index> missed = unreachable(graph, fixed);
  if (!missed.empty()) {
    throw Error(ErrorCode::UnreachableInterior,
                std::to_string(missed.size()) + " interior points have no path of neighbours to the loop",
                missed);
  }
  std::vector<Index> unknown(graph.size(), none);
  std::vector<UV> right, x;
  for (Index i = 0; i < graph.size(); ++i) {
    if (fixed[i]) continue;
    unknown[i] = static_cast<Index>(x.size());
    x.push_back(uv[i]);
  }
  MapSummary summary;
  summary.unknowns = x.size();
  if (x.empty()) return summary;
  Multigrid multigrid(assemble(graph, unknown, uv, right), run);
  const SolveResult solved = solve(multigrid, right, tolerance, 200, x, run);
  summary.iterations = solved.iterations;
  summary.residual = solved.residual;
  constexpr double stalled = 1e-9;  // far above what rounding explains
  if (solved.residual > std::max(tolerance, stalled)) {
    solve_directly(multigrid.matrix(), right, x);
    summary.iterations = 0;
    summary.residual = solve(multigrid, right, tolerance, 0, x, run).residual;
  }
  for (Index i = 0; i < graph.size(); ++i) {
    if (unknown[i] != none) uv[i] = x[unknown[i]];
  }
  return summary;
}

}  // namespace rimline
