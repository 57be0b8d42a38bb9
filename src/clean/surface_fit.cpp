// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/surface_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/model.h"
#include "base/model_clean.h"
#include "local/principal_axes.h"

namespace rimline {
namespace {

constexpr int most = model::stray_neighbours;
constexpr int terms = 6;  // of a quadric z = a + b x + c y + d x^2 + e x y + f y^2 [layout]
using Row = Eigen::Matrix<double, terms, 1>;
using Numbers = std::array<double, most>;

double median(std::span<const double> values) {
  Numbers sorted{};
  const auto end = std::copy(values.begin(), values.end(), sorted.begin());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(sorted.begin(), middle, end);
  return *middle;
}

// Tukey's biweight of a residual over the cut-off.
double biweight(double r) { return r < 1 ? (1 - r * r) * (1 - r * r) : 0; }

struct Plane {
  Point centre;
  Point u, v, normal;
};

Plane fit_plane(std::span<const Point> offsets, std::span<const double> weights) {
  double sum = 0;
  Plane plane;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    sum += weights[i];
    plane.centre = plane.centre + weights[i] * offsets[i];
  }
  plane.centre = (1 / sum) * plane.centre;
  Covariance m;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const Point d = offsets[i] - plane.centre;
    m.xx += weights[i] * d.x * d.x, m.xy += weights[i] * d.x * d.y, m.xz += weights[i] * d.x * d.z;
    m.yy += weights[i] * d.y * d.y, m.yz += weights[i] * d.y * d.z, m.zz += weights[i] * d.z * d.z;
  }
  const PrincipalAxes axes = principal_axes(m);
  plane.u = axes.v[2];
  plane.v = axes.v[1];
  plane.normal = axes.v[0];
  return plane;
}

// The offsets of the nearest neighbours from a point, over its scale.
std::size_t gather(Points points, const Neighbours& neighbours, Index self, double scale, int count,
                   std::array<Point, most>& offsets) {
  const auto ids = neighbours.of(self, std::min(count, neighbours.k));
  for (std::size_t i = 0; i < ids.size(); ++i) offsets[i] = (1 / scale) * (points[ids[i]] - points[self]);
  return ids.size();
}

Plane fit_robust_plane(std::span<const Point> offsets) {
  Numbers weights, residuals{};
  weights.fill(1);
  Plane plane;
  for (int round = 0; round < model::stray_rounds; ++round) {
    plane = fit_plane(offsets, weights);
    for (std::size_t i = 0; i < offsets.size(); ++i)
      residuals[i] = std::abs(dot(offsets[i] - plane.centre, plane.normal));
    const double cut =
        model::stray_plane_cut * (median({residuals.data(), offsets.size()}) + model::stray_plane_floor);
    for (std::size_t i = 0; i < offsets.size(); ++i)
      weights[i] = biweight(residuals[i] / cut) + 1e-9;  // [guard]
  }
  return plane;
}

Row row_of(double x, double y) {
  Row row;
  row << 1, x, y, x * x, x * y, y * y;
  return row;
}

// The quadric that fits heights z over (x, y) under weights.
Row fit_quadric(std::span<const Row> rows, std::span<const double> z, std::span<const double> weights) {
  Eigen::Matrix<double, terms, terms> squares = Eigen::Matrix<double, terms, terms>::Zero();
  Row right = Row::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    squares.selfadjointView<Eigen::Lower>().rankUpdate(rows[i], weights[i]);
    right += weights[i] * z[i] * rows[i];
  }
  for (int i = 0; i < terms; ++i) squares(i, i) += 1e-6;  // rows of scans may not tell a curvature [guard]
  return squares.selfadjointView<Eigen::Lower>().ldlt().solve(right);
}

// The widest gap between angles, in radians.
double widest_gap(std::span<double> angles) {
  constexpr double turn = 2 * std::numbers::pi;
  if (angles.size() < 2) return turn;
  std::ranges::sort(angles);
  double widest = angles.front() + turn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

// The neighbours over a plane, lengths over the scale.
struct Heights {
  std::size_t count = 0;
  std::array<double, most> x, y, z;

  double along(std::size_t i) const { return std::hypot(x[i], y[i]); }
};

Heights over_plane(const Plane& plane, std::span<const Point> offsets) {
  Heights heights;
  heights.count = offsets.size();
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    heights.x[i] = dot(offsets[i], plane.u);
    heights.y[i] = dot(offsets[i], plane.v);
    heights.z[i] = dot(offsets[i], plane.normal);
  }
  return heights;
}

struct Residuals {
  double at_point = 0;  // height of the quadric there
  double deviation = 0;
  Numbers of;

  bool is_on(std::size_t i) const { return of[i] < model::stray_cut * deviation; }
};

Residuals fit_robust_quadric(const Heights& h, double base) {
  const std::size_t n = h.count;
  const double unit = 1 / h.along(n - 1);  // keeps the squares near 1
  std::array<Row, most> rows;
  Numbers weights{};
  Residuals r{};
  for (std::size_t i = 0; i < n; ++i) {
    rows[i] = row_of(unit * h.x[i], unit * h.y[i]);
    r.of[i] = std::abs(h.z[i] - base);
  }
  const double freedom = std::sqrt(static_cast<double>(n) / static_cast<double>(n - terms));
  double cut = model::stray_plane_cut * (median({r.of.data(), n}) + model::stray_plane_floor);
  for (int round = 0; round < model::stray_rounds; ++round) {
    for (std::size_t i = 0; i < n; ++i) weights[i] = biweight(r.of[i] / cut);
    const Row quadric = fit_quadric({rows.data(), n}, {h.z.data(), n}, {weights.data(), n});
    for (std::size_t i = 0; i < n; ++i) r.of[i] = std::abs(h.z[i] - rows[i].dot(quadric));
    r.at_point = quadric[0];
    r.deviation = model::median_to_deviation * freedom * median({r.of.data(), n}) + model::stray_floor;
    cut = model::stray_cut * r.deviation;
  }
  return r;
}

}  // namespace

SurfaceFit fit_without(Points points, const Neighbours& neighbours, Index self, double scale) {
  std::array<Point, most> offsets;
  const std::size_t n = gather(points, neighbours, self, scale, most, offsets);
  return fit_without({offsets.data(), n});
}

SurfaceFit fit_without(std::span<const Point> offsets) {
  offsets = offsets.first(std::min<std::size_t>(offsets.size(), most));
  const std::size_t n = offsets.size();
  if (n < 2 * terms) return {};
  const Plane plane = fit_robust_plane(offsets.first(std::min<std::size_t>(n, model::more_neighbours)));
  const Heights heights = over_plane(plane, offsets);
  const Residuals residuals = fit_robust_quadric(heights, dot(plane.centre, plane.normal));
  SurfaceFit fit{std::abs(residuals.at_point), residuals.deviation};
  Numbers angles{};
  std::size_t around = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (residuals.is_on(i)) {
      fit.nearest = std::min(fit.nearest, heights.along(i));
      if (heights.along(i) < model::stray_around) angles[around++] = std::atan2(heights.y[i], heights.x[i]);
    } else {
      fit.others += norm(offsets[i]) < model::stray_beside;
    }
  }
  fit.gap = widest_gap({angles.data(), around});
  return fit;
}

}  // namespace rimline
