// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/conformal_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map/conformal_energy.h"
#include "mesh/constrained_delaunay.h"
#include "solve/ldl.h"
#include "solve/sparse.h"

namespace rimline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The largest step t along `d` before the triangle loses its area, found where the quadratic in t is zero.
double step_to_flat(const ConformalTriangle::Corners& x, const ConformalTriangle::Corners& d) {
  const auto area = [](UV s, UV t) { return s.u * t.v - s.v * t.u; };
  const UV e = x[1] - x[0], f = x[2] - x[0], de = d[1] - d[0], df = d[2] - d[0];
  const double c = area(e, f), b = area(e, df) + area(de, f), a = area(de, df);
  const double square = b * b - 4 * a * c;
  if (square < 0) return infinite;
  // The root that is not a difference of near numbers, then the other from their product.
  const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
  double least = infinite;
  if (q != 0 && c / q > 0) least = c / q;
  if (a != 0 && q / a > 0) least = std::min(least, q / a);
  return least;
}

// Newton's method on the energies of the surface's triangles, each times its area, and on those of what lies
// between the loops and a box about all.
class Descent {
 public:
  Descent(Points points, const Triangulation& mesh, const std::vector<Loop>& loops, double isometry,
          std::vector<UV> uv)
      : points_(static_cast<Index>(points.size())), loops_(loops), uv_(std::move(uv)) {
    for (const Triangle& t : mesh.triangles) {
      const ConformalTriangle flat({points[t[0]], points[t[1]], points[t[2]]}, isometry);
      if (flat.area() > 0) add(t, flat, flat.area());
    }
    surface_ = triangles_.size();
    uv_.resize(uv_.size() + 4);
  }

  // Energy of the surface alone.
  double energy() const { return energy(uv_, surface_); }
  std::vector<UV> take() {
    uv_.resize(static_cast<std::size_t>(points_));
    return std::move(uv_);
  }

  // Triangulates the region outside of the loops. The rest shape of these triangles is their present shape;
  // their weights add up to `weight`. False where loops cross.
  bool surround(double weight) {
    place_box();
    std::vector<Index> ids;
    std::vector<UV> places;
    std::vector<Loop> outlines(1 + loops_.size());
    const auto add_outline = [&](const std::vector<Index>& outline, Loop& loop) {
      for (const Index v : outline) {
        loop.points.push_back(static_cast<Index>(ids.size()));
        ids.push_back(v);
        places.push_back(uv_[v]);
      }
    };
    add_outline({points_, points_ + 1, points_ + 2, points_ + 3}, outlines[0]);
    for (std::size_t l = 0; l < loops_.size(); ++l) add_outline(loops_[l].points, outlines[l + 1]);
    std::vector<Triangle> outside;
    try {
      outside = constrained_delaunay(places, outlines);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::NotADisc) throw;
      return false;
    }
    triangles_.resize(surface_);
    flat_.erase(flat_.begin() + static_cast<std::ptrdiff_t>(surface_), flat_.end());
    weight_.resize(surface_);
    for (const Triangle& t : outside) {
      const auto corner = [&](int c) { return Point{places[t[c]].u, places[t[c]].v, 0}; };
      const ConformalTriangle flat({corner(0), corner(1), corner(2)});
      if (flat.area() > 0)
        add({ids[t[0]], ids[t[1]], ids[t[2]]}, flat, weight / static_cast<double>(outside.size()));
    }
    return true;
  }

  // Moves the vertices so that the energy falls. False where no such step was found.
  bool step(const Run& run) {
    constexpr double enough = 1e-4;  // share of the decrease that the slope predicts
    constexpr int halvings = 30;
    if (!find_direction(run)) return false;
    const double slope = gradient_.dot(direction_), before = energy(uv_, triangles_.size());
    if (!(slope < 0)) return false;
    double t = std::min(1.0, 0.9 * longest_step());
    std::vector<UV> trial = uv_;
    for (int k = 0; k < halvings; ++k, t /= 2) {
      for (Index v = 0; v < points_; ++v)
        trial[v] = {uv_[v].u + t * direction_[2 * v], uv_[v].v + t * direction_[2 * v + 1]};
      if (!(energy(trial, triangles_.size()) <= before + enough * t * slope)) continue;
      uv_.swap(trial);
      return true;
    }
    return false;
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  void add(const Triangle& t, const ConformalTriangle& flat, double weight) {
    triangles_.push_back(t);
    flat_.push_back(flat);
    weight_.push_back(weight);
  }

  // A box half as large again as the map.
  void place_box() {
    UV low{infinite, infinite}, high{-infinite, -infinite};
    for (const Index v : loops_.front().points) {
      low = {std::min(low.u, uv_[v].u), std::min(low.v, uv_[v].v)};
      high = {std::max(high.u, uv_[v].u), std::max(high.v, uv_[v].v)};
    }
    const double room = std::max(high.u - low.u, high.v - low.v) / 2;
    low = low - UV{room, room};
    high = high + UV{room, room};
    uv_[points_] = low;
    uv_[points_ + 1] = {high.u, low.v};
    uv_[points_ + 2] = high;
    uv_[points_ + 3] = {low.u, high.v};
  }

  ConformalTriangle::Corners corners(const std::vector<UV>& uv, std::size_t i) const {
    return {uv[triangles_[i][0]], uv[triangles_[i][1]], uv[triangles_[i][2]]};
  }

  double energy(const std::vector<UV>& uv, std::size_t count) const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += weight_[i] * flat_[i].value(corners(uv, i));
    return sum;
  }

  bool find_direction(const Run& run) {
    const Index n = 2 * points_;
    gradient_ = Eigen::VectorXd::Zero(n);
    entries_.clear();
    ConformalTriangle::Gradient g;
    ConformalTriangle::Hessian h;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      flat_[i].derivatives(corners(uv_, i), g, h);
      const auto at = [&](int k) { return 2 * triangles_[i][k / 2] + k % 2; };
      for (int r = 0; r < 6; ++r) {
        if (at(r) >= n) continue;  // the box is fixed
        gradient_[at(r)] += weight_[i] * g[r];
        for (int c = 0; c < 6; ++c) {
          if (at(r) >= at(c)) entries_.emplace_back(at(r), at(c), weight_[i] * h(r, c));
        }
      }
    }
    Matrix lower(n, n);
    lower.setFromTriplets(entries_.begin(), entries_.end());
    // Damped on the diagonal: similarities leave the energy of the surface unchanged, so it is singular.
    constexpr double little = 1e-9;
    for (Index i = 0; i < n; ++i) {
      double& d = lower.coeffRef(i, i);
      d = std::max(d * (1 + little), 1e-300);
    }
    const LdlFactor factor(lower, run);
    if (!factor.is_regular()) return false;
    direction_ = factor.solve(-gradient_);
    return direction_.allFinite();
  }

  double longest_step() const {
    double t = infinite;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      ConformalTriangle::Corners d;
      for (int c = 0; c < 3; ++c) {
        const Index v = triangles_[i][c];
        if (v < points_) d[c] = {direction_[2 * v], direction_[2 * v + 1]};
      }
      t = std::min(t, step_to_flat(corners(uv_, i), d));
    }
    return t;
  }

  Index points_;
  const std::vector<Loop>& loops_;
  std::vector<UV> uv_;               // of the points, then the corners of the box
  std::vector<Triangle> triangles_;  // those of the surface first
  std::vector<ConformalTriangle> flat_;
  std::vector<double> weight_;
  std::size_t surface_ = 0;  // triangles of it
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_, direction_;
};

}  // namespace

double conformal_distortion(Points points, const Triangulation& mesh, const std::vector<UV>& uv) {
  double area = 0, sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const ConformalTriangle flat({points[t[0]], points[t[1]], points[t[2]]});
    area += flat.area();
    if (flat.area() > 0) sum += flat.area() * flat.value({uv[t[0]], uv[t[1]], uv[t[2]]});
  }
  return area > 0 ? sum / area : 1;
}

int most_descent_steps(std::size_t triangles) {
  constexpr std::size_t work = 450'000, least = 5, most = 100;
  return static_cast<int>(std::clamp(work / std::max<std::size_t>(1, triangles), least, most));
}

int relax_conformally(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                      const DescentOptions& options, std::vector<UV>& uv, const Run& run) {
  constexpr int look_back = 5;
  constexpr double settled = 0.05;  // of the energy in excess of that without distortion
  constexpr double outside = 0.01;  // of the same, for what lies outside
  Descent descent(points, mesh, loops, options.isometry, uv);
  double least = 0;  // the energy if there were no distortion
  for (const Triangle& t : mesh.triangles)
    least += (1 + options.isometry) * ConformalTriangle({points[t[0]], points[t[1]], points[t[2]]}).area();
  std::vector<double> excess{descent.energy() - least};
  if (!(least > 0) || !std::isfinite(excess.front())) return 0;
  const int most_steps =
      options.most_steps > 0 ? options.most_steps : most_descent_steps(mesh.triangles.size());
  int steps = 0;
  while (steps < most_steps) {
    run.check_cancel();
    if (!descent.surround(outside * excess.back()) || !descent.step(run)) break;
    ++steps;
    excess.push_back(descent.energy() - least);
    if (steps >= look_back && excess.back() > (1 - settled) * excess[steps - look_back]) break;
  }
  if (steps > 0) uv = descent.take();
  return steps;
}

}  // namespace rimline
