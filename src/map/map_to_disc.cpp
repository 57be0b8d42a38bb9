// SPDX-License-Identifier: GPL-3.0-or-later
// After section 5 of Maes & Bultheel 2004 and Floater & Reimers, "Meshless parameterization and surface
// reconstruction", Comp. Aided Geom. Design 18, 2001.
#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "map/reachable.h"
#include "rimline/parameterize.h"

namespace rimline {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

// Eq. (4) over the interior points: (I - Lambda) u = b, with the loop's share on the right-hand side.
struct System {
  Matrix matrix;
  Vector right_u, right_v;
  std::vector<Index> interior;  // point of each unknown
};

System assemble(const Neighbours& neighbours, int k, const std::vector<char>& on_loop,
                const std::vector<UV>& uv) {
  System system;
  std::vector<Index> unknown(uv.size(), none);
  for (Index i = 0; i < static_cast<Index>(uv.size()); ++i) {
    if (on_loop[i]) continue;
    unknown[i] = static_cast<Index>(system.interior.size());
    system.interior.push_back(i);
  }
  const Index count = static_cast<Index>(system.interior.size());
  system.right_u = system.right_v = Vector::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(count) * (k + 1));
  for (Index row = 0; row < count; ++row) {
    const auto list = neighbours.of(system.interior[row], k);
    const auto distances = neighbours.distances_of(system.interior[row]);
    double sum = 0;
    for (int j = 0; j < k; ++j) sum += 1 / distances[j];
    entries.emplace_back(row, row, 1);
    for (int j = 0; j < k; ++j) {
      const double lambda = 1 / distances[j] / sum;  // the reciprocal distance weights of section 5
      if (on_loop[list[j]]) {
        system.right_u[row] += lambda * uv[list[j]].u;
        system.right_v[row] += lambda * uv[list[j]].v;
      } else {
        entries.emplace_back(row, unknown[list[j]], -lambda);
      }
    }
  }
  system.matrix.resize(count, count);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

double relative_residual(const Matrix& matrix, const Vector& solution, const Vector& right) {
  const double scale = right.norm();
  return (matrix * solution - right).norm() / (scale > 0 ? scale : 1);
}

// u and v of all unknowns, and how well they solve the system.
struct Solution {
  Vector u, v;
  MapSummary summary;
};

void measure_residual(const System& system, Solution& s) {
  s.summary.residual = std::max(relative_residual(system.matrix, s.u, system.right_u),
                                relative_residual(system.matrix, s.v, system.right_v));
}

bool solved(const Solution& s, double residual) { return s.summary.residual <= residual; }

// An incomplete factorization that looks at cancel each time it is applied: twice an iteration.
class Preconditioner : public Eigen::IncompleteLUT<double> {
 public:
  void watch(const Run& run) { run_ = &run; }
  Vector solve(const Vector& right) const {
    if (run_ != nullptr) run_->check_cancel();
    return Eigen::IncompleteLUT<double>::solve(right);
  }

 private:
  const Run* run_ = nullptr;
};

// The fast way. BiCGSTAB may stall above the residual where the points crowd; restarting it from where it
// stands helps until rounding ends it.
Solution solve_iteratively(const System& system, double residual, const Run& run) {
  Eigen::BiCGSTAB<Matrix, Preconditioner> solver;
  solver.preconditioner().watch(run);
  solver.preconditioner().setDroptol(1e-3);
  solver.preconditioner().setFillfactor(5);
  solver.compute(system.matrix);
  solver.setTolerance(0.5 * residual);
  solver.setMaxIterations(1000);
  Solution s{Vector::Zero(system.right_u.size()), Vector::Zero(system.right_v.size()), {}};
  constexpr int most_starts = 3;
  for (int i = 0; i < most_starts; ++i) {
    run.progress(Stage::Parameterize, i, most_starts);
    s.u = solver.solveWithGuess(system.right_u, s.u).eval();
    s.summary.iterations += static_cast<int>(solver.iterations());
    s.v = solver.solveWithGuess(system.right_v, s.v).eval();
    s.summary.iterations += static_cast<int>(solver.iterations());
    measure_residual(system, s);
    if (solved(s, residual) || !std::isfinite(s.summary.residual)) break;
  }
  return s;
}

// The sure way, for systems it can hold, with one step of iterative refinement.
Solution solve_directly(const System& system, const Run& run) {
  run.progress(Stage::Parameterize, 0, 2);
  const Eigen::SparseMatrix<double> columns = system.matrix;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(columns);
  if (solver.info() != Eigen::Success) return {};
  run.progress(Stage::Parameterize, 1, 2);
  Solution s;
  s.u = solver.solve(system.right_u);
  s.v = solver.solve(system.right_v);
  s.u += solver.solve(system.right_u - system.matrix * s.u);
  s.v += solver.solve(system.right_v - system.matrix * s.v);
  measure_residual(system, s);
  return s;
}

Solution solve(const System& system, double residual, const Run& run) {
  constexpr Index direct_limit = 300'000;  // unknowns; the factors of a million take over 8 GB
  Solution s = solve_iteratively(system, residual, run);
  if (solved(s, residual)) return s;
  const double iterative_residual = s.summary.residual;
  if (system.interior.size() <= direct_limit) {
    s = solve_directly(system, run);
    if (s.u.size() == system.right_u.size() && solved(s, residual)) return s;
  }
  throw Error(ErrorCode::NoConvergence, "the map's linear system was solved to a residual of " +
                                            std::to_string(iterative_residual) +
                                            " only; a larger map_k or residual may help");
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
    arc[i + 1] = arc[i] + distance(points[loop[i]], points[loop[(i + 1) % loop.size()]]);
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
  const System system = assemble(neighbours, k, on_loop, result.uv);
  result.summary.unknowns = system.interior.size();
  if (system.interior.empty()) return result;
  const Solution solution = solve(system, options.residual, run);
  for (std::size_t i = 0; i < system.interior.size(); ++i) {
    result.uv[system.interior[i]] = {solution.u[i], solution.v[i]};
  }
  result.summary.iterations = solution.summary.iterations;
  result.summary.residual = solution.summary.residual;
  return result;
}

}  // namespace rimline
