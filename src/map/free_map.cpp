// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/free_map.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/vec.h"
#include "solve/ldl.h"

namespace rimline {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// Two points of the loop that are nearly as far apart as possible: the farthest from the farthest from its
// first.
std::pair<Index, Index> far_pair(Points points, const std::vector<Index>& loop) {
  const auto farthest = [&](Index from) {
    return *std::max_element(loop.begin(), loop.end(), [&](Index a, Index b) {
      return squared_distance(points[a], points[from]) < squared_distance(points[b], points[from]);
    });
  };
  const Index a = farthest(loop.front());
  return {a, farthest(a)};
}

// The conformal energy as a quadratic form, and its minimization.
class ConformalSystem {
 public:
  // Unknown 2 i is u of vertex i, 2 i + 1 its v; those of two points of the outer loop are held.
  ConformalSystem(Points points, const Triangulation& mesh, const std::vector<Index>& outer_loop)
      : points_(points), mesh_(mesh), held_(2 * points.size(), 0), unknown_(2 * points.size(), none) {
    const auto [left, right] = far_pair(points, outer_loop);
    held_[2 * right] = distance(points[left], points[right]);
    for (Index i = 0; i < static_cast<Index>(unknown_.size()); ++i) {
      if (i / 2 != left && i / 2 != right) unknown_[i] = count_++;
    }
  }

  MapSummary solve(double least, std::vector<UV>& uv, const Run& run) {
    right_ = Eigen::VectorXd::Zero(count_);
    add_triangles(least);
    run.check_cancel();
    Matrix lower(count_, count_);
    lower.setFromTriplets(entries_.begin(), entries_.end());
    const LdlFactor factor(lower, run);
    if (!factor.is_regular())
      throw Error(ErrorCode::NoConvergence, "the system of the free map could not be factorized");
    Eigen::VectorXd x = factor.solve(right_);
    x += factor.solve(right_ - lower.selfadjointView<Eigen::Lower>() * x);  // once refined
    MapSummary summary;
    summary.unknowns = static_cast<std::size_t>(count_);
    summary.residual =
        (right_ - lower.selfadjointView<Eigen::Lower>() * x).norm() / std::max(right_.norm(), 1e-300);
    uv.resize(points_.size());
    const auto value = [&](Index k) { return unknown_[k] == none ? held_[k] : x[unknown_[k]]; };
    for (Index i = 0; i < static_cast<Index>(points_.size()); ++i) uv[i] = {value(2 * i), value(2 * i + 1)};
    return summary;
  }

 private:
  void add(Index row, Index column, double value) {
    const Index i = unknown_[std::max(row, column)], j = unknown_[std::min(row, column)];
    if (i != none && j != none) {
      entries_.emplace_back(i, j, value);
    } else if (i != none) {
      right_[i] -= value * held_[std::min(row, column)];
    } else if (j != none) {
      right_[j] -= value * held_[std::max(row, column)];
    }
  }

  // Dirichlet energy of an edge.
  void add_edge(Index a, Index b, double weight) {
    for (int k = 0; k < 2; ++k) {
      add(2 * a + k, 2 * a + k, weight);
      add(2 * b + k, 2 * b + k, weight);
      add(2 * a + k, 2 * b + k, -weight);
    }
  }

  void add_triangles(double least) {
    for (Index t = 0; t < mesh_.size(); ++t) {
      const Triangle& v = mesh_.triangles[t];
      for (int c = 0; c < 3; ++c) {
        const Index a = v[next(c)], b = v[previous(c)], other = mesh_.adjacent[t][c];
        if (other != none) {
          if (other < t) continue;  // visited from the other side
          const Index apex = mesh_.triangles[other][mesh_.corner_across(other, t)];
          add_edge(a, b, std::max(least, 0.5 * (cotangent(v[c], a, b) + cotangent(apex, a, b))));
          continue;
        }
        add_edge(a, b, 0.5 * cotangent(v[c], a, b));
        // Less the area, half of which is the cross product along each boundary edge from a to b.
        add(2 * a, 2 * b + 1, -0.5);
        add(2 * b, 2 * a + 1, 0.5);
      }
    }
  }

  double cotangent(Index p, Index a, Index b) const {
    const Point e = points_[a] - points_[p], f = points_[b] - points_[p];
    return dot(e, f) / std::max(norm(cross(e, f)), 1e-12 * (dot(e, e) + dot(f, f)));
  }

  Points points_;
  const Triangulation& mesh_;
  std::vector<double> held_;
  std::vector<Index> unknown_;
  Index count_ = 0;
  Entries entries_;
  Eigen::VectorXd right_;
};

double area_of(Points points, const Triangulation& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += triangle_area(points, t);
  }
  return sum;
}

double area_of(const Triangulation& mesh, const std::vector<UV>& uv) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += 0.5 * twice_area(uv, t);
  return sum;
}

}  // namespace

MapSummary free_map(Points points, const Triangulation& mesh, const std::vector<Index>& outer_loop,
                    double least, std::vector<UV>& uv, const Run& run) {
  run.check_cancel();
  return ConformalSystem(points, mesh, outer_loop).solve(least, uv, run);
}

void scale_to_area(Points points, const Triangulation& mesh, std::vector<UV>& uv) {
  const double scale = std::sqrt(area_of(points, mesh) / std::max(area_of(mesh, uv), 1e-300));
  for (UV& p : uv) p = {scale * p.u, scale * p.v};
}

void lay_level(Points points, const std::vector<Index>& outer_loop, std::vector<UV>& uv) {
  const auto [left, right] = far_pair(points, outer_loop);
  const double u = uv[right].u - uv[left].u, v = uv[right].v - uv[left].v, length = std::hypot(u, v);
  if (!(length > 0)) return;
  const double c = u / length, s = v / length;
  for (UV& p : uv) p = {c * p.u + s * p.v, c * p.v - s * p.u};
}

}  // namespace rimline
