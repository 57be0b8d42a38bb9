// SPDX-License-Identifier: GPL-3.0-or-later
// After section 5 of Maes & Bultheel 2004 and Floater & Reimers, "Meshless parameterization and surface
// reconstruction", Comp. Aided Geom. Design 18, 2001.
#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "map/reachable.h"
#include "rimline/parameterize.h"
#include "solve/multigrid.h"

namespace rimline {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;  // u and v of each unknown
using Pair = Eigen::Array<double, 1, 2>;                                    // a number for u and one for v

// Eq. (4) over the interior points: (I - Lambda) u = b, with the loop's share on the right-hand side.
struct System {
  Matrix matrix;
  Columns right;
  Eigen::VectorXd weight_sum;   // of each row before it was divided by it
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
  system.right = Columns::Zero(count, 2);
  system.weight_sum = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(count) * (k + 1));
  for (Index row = 0; row < count; ++row) {
    const auto list = neighbours.of(system.interior[row], k);
    const auto distances = neighbours.distances_of(system.interior[row]);
    double& sum = system.weight_sum[row];
    for (int j = 0; j < k; ++j) sum += 1 / distances[j];
    entries.emplace_back(row, row, 1);
    for (int j = 0; j < k; ++j) {
      const double lambda = 1 / distances[j] / sum;  // the reciprocal distance weights of section 5
      if (on_loop[list[j]]) {
        system.right(row, 0) += lambda * uv[list[j]].u;
        system.right(row, 1) += lambda * uv[list[j]].v;
      } else {
        entries.emplace_back(row, unknown[list[j]], -lambda);
      }
    }
  }
  system.matrix.resize(count, count);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

// The system with its rows multiplied by their sums and made symmetric: 1 / distance is the same both ways,
// so all that this changes is one-sided neighbours, whose weight is halved and given to both.
SymmetricMatrix symmetric_part(const System& system) {
  const Matrix scaled = system.weight_sum.asDiagonal() * system.matrix;
  const Matrix both = 0.5 * (scaled + Matrix(scaled.transpose()));
  SymmetricMatrix result;
  result.diagonal.resize(both.rows());
  result.offsets.reserve(both.rows() + 1);
  for (Index row = 0; row < both.rows(); ++row) {
    double others = 0;
    for (Matrix::InnerIterator entry(both, row); entry; ++entry) {
      if (entry.col() == row) {
        result.diagonal[row] = entry.value();
      } else {
        result.columns.push_back(static_cast<Index>(entry.col()));
        result.values.push_back(entry.value());
        others -= entry.value();
      }
    }
    // A point that many have for a neighbour gains more weight than its row had.
    result.diagonal[row] = std::max(result.diagonal[row], others);
    result.offsets.push_back(static_cast<Index>(result.columns.size()));
  }
  return result;
}

// The multigrid of the symmetric part, as a preconditioner of the system itself.
class Preconditioner {
 public:
  Preconditioner(const System& system, const Run& run)
      : weight_sum_(system.weight_sum), multigrid_(symmetric_part(system), run), run_(run) {}

  Columns operator()(const Columns& right) {
    run_.check_cancel();
    std::vector<UV> b(right.rows()), x(right.rows());
    for (Index i = 0; i < right.rows(); ++i) {
      b[i] = {weight_sum_[i] * right(i, 0), weight_sum_[i] * right(i, 1)};
    }
    multigrid_.precondition(b, x);
    Columns result(right.rows(), 2);
    for (Index i = 0; i < right.rows(); ++i) result.row(i) << x[i].u, x[i].v;
    return result;
  }

 private:
  const Eigen::VectorXd& weight_sum_;
  Multigrid multigrid_;
  const Run& run_;
};

Pair dot(const Columns& a, const Columns& b) { return a.cwiseProduct(b).colwise().sum().array(); }
Columns scaled(const Columns& a, const Pair& by) { return a.array().rowwise() * by; }
// a / b, and 0 for a column that is solved already.
Pair ratio(const Pair& a, const Pair& b) { return (b == 0).select(Pair::Zero(), a / b); }

double worst(const Pair& squared_residual, const Pair& squared_scale) {
  const Pair scale = (squared_scale > 0).select(squared_scale, Pair::Ones());
  return std::sqrt((squared_residual / scale).maxCoeff());
}

// u and v of all unknowns, and how well they solve the system.
struct Solution {
  Columns uv;
  MapSummary summary;
};

void measure_residual(const System& system, Solution& s) {
  const Columns rest = system.right - system.matrix * s.uv;
  s.summary.residual = worst(dot(rest, rest), dot(system.right, system.right));
}

// BiCGSTAB (van der Vorst 1992) from where `s` stands, u and v at once.
void iterate(const System& system, Preconditioner& precondition, double tolerance, Solution& s) {
  constexpr int most_iterations = 300;
  const Pair scale = dot(system.right, system.right);
  Columns r = system.right - system.matrix * s.uv;
  const Columns shadow = r;
  Columns p = Columns::Zero(r.rows(), 2), v = p;
  Pair rho = Pair::Ones(), alpha = rho, omega = rho;
  for (int i = 0; i < most_iterations; ++i) {
    if (worst(dot(r, r), scale) <= tolerance) return;
    const Pair next_rho = dot(shadow, r);
    p = r + scaled(p - scaled(v, omega), ratio(next_rho, rho) * ratio(alpha, omega));
    rho = next_rho;
    const Columns y = precondition(p);
    v = system.matrix * y;
    alpha = ratio(rho, dot(shadow, v));
    r -= scaled(v, alpha);
    const Columns z = precondition(r);
    const Columns t = system.matrix * z;
    omega = ratio(dot(t, r), dot(t, t));
    s.uv += scaled(y, alpha) + scaled(z, omega);
    r -= scaled(t, omega);
    ++s.summary.iterations;
  }
}

// The fast way. BiCGSTAB may stall where the points crowd; restarting it from where it stands helps until
// rounding ends it.
Solution solve_iteratively(const System& system, double residual, const Run& run) {
  Solution s{Columns::Zero(system.right.rows(), 2), {}};
  Preconditioner precondition(system, run);
  constexpr int most_starts = 4;
  for (int i = 0; i < most_starts; ++i) {
    run.progress(Stage::Parameterize, i, most_starts);
    iterate(system, precondition, 0.5 * residual, s);
    measure_residual(system, s);
    if (s.summary.residual <= residual || !std::isfinite(s.summary.residual)) break;
  }
  return s;
}

// The sure way, for systems it can hold, with one step of iterative refinement.
Solution solve_directly(const System& system, const Run& run) {
  run.progress(Stage::Parameterize, 0, 2);
  const Eigen::SparseMatrix<double> columns = system.matrix;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(columns);
  Solution s{{}, {0, 0, std::numeric_limits<double>::infinity()}};
  if (solver.info() != Eigen::Success) return s;
  run.progress(Stage::Parameterize, 1, 2);
  const Eigen::MatrixXd first = solver.solve(Eigen::MatrixXd(system.right));
  const Eigen::MatrixXd correction = solver.solve(Eigen::MatrixXd(system.right - system.matrix * first));
  s.uv = first + correction;
  measure_residual(system, s);
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
    result.uv[system.interior[i]] = {solution.uv(i, 0), solution.uv(i, 1)};
  }
  result.summary.iterations = solution.summary.iterations;
  result.summary.residual = solution.summary.residual;
  return result;
}

}  // namespace rimline
