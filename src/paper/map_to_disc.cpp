// SPDX-License-Identifier: GPL-3.0-or-later
// After section 5 of Maes & Bultheel 2004 and Floater & Reimers, "Meshless parameterization and surface
// reconstruction", Comp. Aided Geom. Design 18, 2001.
#include "rimline/map_to_disc.h"

#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/vec.h"
#include "paper/reachable.h"
#include "solve/aggregation.h"

namespace rimline {
namespace {

// Eq. (4) over the interior points, row i multiplied by the sum of its weights 1 / distance: where two
// points are neighbours of each other, the matrix is symmetric then.
struct System {
  RowMatrix matrix;
  std::vector<double> weight_sum;
  std::vector<UV> right;        // the loop's contribution to each combination, for rows as in eq. (4)
  std::vector<Index> interior;  // point of each unknown
};

System assemble(Points points, const Neighbours& neighbours, int k, const std::vector<char>& on_loop,
                const std::vector<UV>& uv) {
  System system;
  std::vector<Index> unknown(uv.size(), none);
  for (Index i = 0; i < static_cast<Index>(uv.size()); ++i) {
    if (on_loop[i]) continue;
    unknown[i] = static_cast<Index>(system.interior.size());
    system.interior.push_back(i);
  }
  const std::size_t count = system.interior.size();
  RowMatrix& matrix = system.matrix;
  system.right.resize(count);
  system.weight_sum.resize(count);
  matrix.diagonal.resize(count);
  matrix.offsets.reserve(count + 1);
  matrix.columns.reserve(count * k);
  matrix.values.reserve(count * k);
  for (std::size_t row = 0; row < count; ++row) {
    const Index point = system.interior[row];
    const auto list = neighbours.of(point, k);
    double sum = 0;
    UV on_rim;
    for (int j = 0; j < k; ++j) {
      const double weight = 1 / distance_to(points, neighbours, point, j);  // as in section 5
      sum += weight;
      if (on_loop[list[j]]) {
        on_rim = on_rim + weight * uv[list[j]];
      } else {
        matrix.columns.push_back(unknown[list[j]]);
        matrix.values.push_back(-weight);
      }
    }
    matrix.offsets.push_back(static_cast<Index>(matrix.columns.size()));
    matrix.diagonal[row] = system.weight_sum[row] = sum;
    system.right[row] = (1 / sum) * on_rim;
  }
  return system;
}

// u and v of all unknowns, and the residual.
struct Solution {
  std::vector<UV> uv;
  MapSummary summary;
};

// The iterative solver.
Solution solve_iteratively(const System& system, double residual, const Run& run) {
  constexpr int most_iterations = 500;
  run.progress(Stage::Parameterize, 0, 0);
  AggregationMultigrid multigrid(system.matrix, run);
  Solution s;
  s.uv.resize(system.right.size());
  const ConvexSolve done =
      solve(multigrid, system.weight_sum, system.right, residual, most_iterations, s.uv, run);
  s.summary.iterations = done.iterations;
  s.summary.residual = done.residual;
  return s;
}

// The direct solver, for systems that fit in memory, with one step of iterative refinement.
Solution solve_directly(const System& system, const Run& run) {
  run.progress(Stage::Parameterize, 0, 2);
  const RowMatrix& rows = system.matrix;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < rows.size(); ++i) {
    const double by = 1 / system.weight_sum[i];
    entries.emplace_back(i, i, by * rows.diagonal[i]);
    for (Index e = rows.offsets[i]; e < rows.offsets[i + 1]; ++e)
      entries.emplace_back(i, rows.columns[e], by * rows.values[e]);
  }
  Eigen::SparseMatrix<double> matrix(rows.size(), rows.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
  const Eigen::MatrixXd right = Eigen::Map<const Columns>(&system.right[0].u, rows.size(), 2);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  Solution s;
  s.summary.residual = std::numeric_limits<double>::infinity();
  if (solver.info() != Eigen::Success) return s;
  run.progress(Stage::Parameterize, 1, 2);
  Eigen::MatrixXd uv = solver.solve(right);
  uv += solver.solve(Eigen::MatrixXd(right - matrix * uv));
  s.uv.resize(rows.size());
  for (Index i = 0; i < rows.size(); ++i) s.uv[i] = {uv(i, 0), uv(i, 1)};
  const Eigen::MatrixXd rest = right - matrix * uv;
  s.summary.residual =
      std::max(rest.col(0).norm() / right.col(0).norm(), rest.col(1).norm() / right.col(1).norm());
  return s;
}

Solution solve(const System& system, double residual, const Run& run) {
  constexpr std::size_t direct_limit = 300'000;  // unknowns; the factors of a million take over 8 GB
  Solution s = solve_iteratively(system, residual, run);
  if (s.summary.residual <= residual) return s;
  const double iterative_residual = s.summary.residual;
  if (system.interior.size() <= direct_limit) s = solve_directly(system, run);
  if (s.summary.residual <= residual) return s;
  throw Error(ErrorCode::NoConvergence,
              fmt::format("the map's linear system was solved to a residual of {:.2g} only, {:.2g} was asked "
                          "for; a larger map_k or residual may help",
                          iterative_residual, residual));
}

void check_reachable(const Neighbours& neighbours, int k, std::span<const Index> loop) {
  std::vector<Index> ids = unreachable_points(neighbours, k, loop);
  if (ids.empty()) return;
  const std::string message = fmt::format(
      "{} interior point{} no chain of neighbours to the loop: the set may have several parts, or "
      "map_k is too small",
      ids.size(), ids.size() == 1 ? " has" : "s have");
  throw Error(ErrorCode::UnreachableInterior, message, std::move(ids));
}

}  // namespace

std::vector<UV> circle_by_chord_length(Points points, std::span<const Index> loop) {
  std::vector<double> arc(loop.size() + 1, 0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    arc[i + 1] = arc[i] + distance(points[loop[i]], points[loop[next_in(i, loop.size())]]);
  }
  std::vector<UV> result(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = 2 * std::numbers::pi * arc[i] / arc.back();
    result[i] = {std::cos(angle), std::sin(angle)};
  }
  return result;
}

DiscMap map_to_disc(Points points, const Neighbours& neighbours, std::span<const Index> loop,
                    const ParameterizeOptions& options, const Run& run) {
  run.progress(Stage::Parameterize, 0, 0);
  const int k = std::min(options.map_k, neighbours.k);
  check_reachable(neighbours, k, loop);

  DiscMap result;
  result.uv.resize(points.size());
  std::vector<char> on_loop(points.size(), 0);
  const std::vector<UV> circle = circle_by_chord_length(points, loop);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    result.uv[loop[i]] = circle[i];
    on_loop[loop[i]] = 1;
  }
  const System system = assemble(points, neighbours, k, on_loop, result.uv);
  result.summary.unknowns = system.interior.size();
  if (system.interior.empty()) return result;
  const Solution solution = solve(system, options.residual, run);
  for (std::size_t i = 0; i < system.interior.size(); ++i) {
    result.uv[system.interior[i]] = solution.uv[i];
  }
  result.summary.iterations = solution.summary.iterations;
  result.summary.residual = solution.summary.residual;
  return result;
}

}  // namespace rimline
