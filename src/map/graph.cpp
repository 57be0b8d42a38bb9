// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/graph.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <string>
#include <utility>

#include "solve/ldl.h"
#include "solve/multigrid.h"

namespace rimline {
namespace {

// The direct solver, for systems on which the multigrid stalls.
void solve_directly(const SymmetricMatrix& a, const std::vector<UV>& right, std::vector<UV>& x,
                    const Run& run) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < a.size(); ++i) {
    entries.emplace_back(i, i, a.diagonal[i]);
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
      if (a.columns[e] < i) entries.emplace_back(i, a.columns[e], a.values[e]);
    }
  }
  Eigen::SparseMatrix<double> lower(a.size(), a.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  const LdlFactor factor(lower, run);
  if (!factor.is_regular()) return;
  Eigen::VectorXd u(a.size()), v(a.size());
  for (Index i = 0; i < a.size(); ++i) {
    u[i] = right[i].u;
    v[i] = right[i].v;
  }
  u = factor.solve(u);
  v = factor.solve(v);
  for (Index i = 0; i < a.size(); ++i) x[i] = {u[i], v[i]};
}

struct HalfEdge {
  Index other;
  double weight;
};

// Sorts a short row by id and adds up entries of the same node. Equal ids keep their order, so that the sums
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

MapSystem graph_system(const Graph& graph, const std::vector<char>& fixed, const std::vector<UV>& uv) {
  MapSystem system;
  system.unknown.assign(graph.size(), none);
  Index count = 0;
  for (Index i = 0; i < graph.size(); ++i) {
    if (!fixed[i]) system.unknown[i] = count++;
  }
  SymmetricMatrix& a = system.matrix;
  a.columns.reserve(graph.neighbours.size());
  a.values.reserve(graph.neighbours.size());
  for (Index i = 0; i < graph.size(); ++i) {
    if (fixed[i]) continue;
    double sum = 0;
    UV held;
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      const Index j = graph.neighbours[e];
      sum += graph.weights[e];
      if (fixed[j]) {
        held = held + graph.weights[e] * uv[j];
      } else {
        a.columns.push_back(system.unknown[j]);
        a.values.push_back(-graph.weights[e]);
      }
    }
    a.diagonal.push_back(sum);
    a.offsets.push_back(static_cast<Index>(a.columns.size()));
    system.right.push_back(held);
  }
  return system;
}

MapSummary solve_map(const Graph& graph, const std::vector<char>& fixed, double tolerance,
                     std::vector<UV>& uv, const Run& run) {
  std::vector<Index> missed = unreachable(graph, fixed);
  if (!missed.empty()) {
    throw Error(ErrorCode::UnreachableInterior,
                std::to_string(missed.size()) + " interior points have no path of neighbours to the loop",
                missed);
  }
  return solve_system(graph_system(graph, fixed, uv), tolerance, uv, run);
}

MapSummary solve_system(MapSystem system, double tolerance, std::vector<UV>& uv, const Run& run) {
  MapSummary summary;
  std::vector<UV> x;
  x.reserve(system.right.size());
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (system.unknown[i] != none) x.push_back(uv[i]);
  }
  summary.unknowns = x.size();
  if (x.empty()) return summary;
  Multigrid multigrid(std::move(system.matrix), run);
  const SolveResult solved = solve(multigrid, system.right, tolerance, 200, x, run);
  summary.iterations = solved.iterations;
  summary.residual = solved.residual;
  constexpr double stalled = 1e-9;  // far above what rounding explains
  if (solved.residual > std::max(tolerance, stalled)) {
    solve_directly(multigrid.matrix(), system.right, x, run);
    summary.iterations = 0;
    summary.residual = solve(multigrid, system.right, tolerance, 0, x, run).residual;
  }
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (system.unknown[i] != none) uv[i] = x[system.unknown[i]];
  }
  return summary;
}

}  // namespace rimline
