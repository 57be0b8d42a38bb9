// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/noise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/model.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "local/frame.h"
#include "local/ramp.h"

namespace rimline {
namespace {

constexpr int terms = 6;  // of a quadric z = a + b x + c y + d x^2 + e x y + f y^2 [layout]

// The quadric over the tangent plane of a point that fits it and its neighbours best.
struct Quadric {
  Point normal;
  double height = 0;     // of the quadric at the point, along the normal
  double deviation = 0;  // of the points from it, for the degrees of freedom that are left
};

Quadric fit_quadric(Points points, const Neighbours& neighbours, Index self, int count) {
  using Row = Eigen::Matrix<double, terms, 1>;
  const auto ids = neighbours.of(self, std::min(count, neighbours.k));
  const Frame frame = fit_frame(points, ids, self);
  Quadric quadric{frame.normal};
  if (ids.size() < terms + 2) return quadric;
  const double scale = 1 / distance(points[self], points[ids.back()]);
  Eigen::Matrix<double, terms, terms> squares = Eigen::Matrix<double, terms, terms>::Zero();
  Row right = Row::Zero();
  double heights = 0;
  const auto take = [&](Point d) {
    const double x = scale * dot(d, frame.u), y = scale * dot(d, frame.v), z = dot(d, frame.normal);
    Row row;
    row << 1, x, y, x * x, x * y, y * y;
    squares.selfadjointView<Eigen::Lower>().rankUpdate(row);
    right += z * row;
    heights += z * z;
  };
  take({});
  for (const Index id : ids) take(points[id] - points[self]);
  for (int i = 0; i < terms; ++i) squares(i, i) += 1e-9;  // scan lines may not tell a curvature [guard]
  const Row fit = squares.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  quadric.height = fit[0];
  const double rest = std::max(0.0, heights - fit.dot(right));
  quadric.deviation = std::sqrt(rest / static_cast<double>(ids.size() + 1 - terms));
  return quadric;
}

}  // namespace

double quadric_deviation(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         Index point) {
  return fit_quadric(points, neighbours, point, model::noise_neighbours).deviation / spacing[point];
}

double noise_level(std::vector<double> deviations, double variation_of_nearest) {
  constexpr double quarter = 0.25, twentieth = 0.05;  // [layout] shares
  const double level = quantile(deviations, quarter) / model::noise_quartile;
  if (level == 0) return 0;
  const double is_everywhere = ramp(quantile(deviations, twentieth) / model::noise_twentieth / level,
                                    model::relief_ends, model::noise_everywhere);
  const double is_close = ramp(variation_of_nearest, model::variation_even, model::variation_noisy);
  return level * std::max(is_everywhere, is_close);
}

double noise_weight(double level) { return ramp(level, model::noise_least, model::noise_full); }

std::vector<Point> take_off_noise(Points points, const Neighbours& neighbours, double weight,
                                  const Run& run) {
  constexpr int count = model::denoise_neighbours;
  std::vector<Point> moved(points.begin(), points.end());
  parallel_for_each(points.size(), Stage::Survey, run, [&](Index i) {
    const Quadric quadric = fit_quadric(points, neighbours, i, count);
    const Point there = points[i] + weight * quadric.height * quadric.normal;
    if (is_finite(there)) moved[i] = there;  // not where squares of the distances are no numbers any more
  });
  return moved;
}

}  // namespace rimline
