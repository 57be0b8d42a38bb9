// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/denoise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "exact/frame.h"
#include "parallel.h"

namespace rimline::exact {
namespace {

constexpr int terms = 6;  // of a quadric z = a + b x + c y + d x^2 + e x y + f y^2

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
  for (int i = 0; i < terms; ++i) squares(i, i) += 1e-9;  // scan lines may not tell a curvature
  const Row fit = squares.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  quadric.height = fit[0];
  const double rest = std::max(0.0, heights - fit.dot(right));
  quadric.deviation = std::sqrt(rest / static_cast<double>(ids.size() + 1 - terms));
  return quadric;
}

// 0 up to the first value, 1 from the last on.
double ramp(double value, double first, double last) {
  return std::clamp((value - first) / (last - first), 0.0, 1.0);
}

constexpr std::size_t most_asked = 4096;  // points that stand for all

std::size_t stride_over(std::size_t count) { return 1 + (count - 1) / most_asked; }

// Of the distances to the nearest neighbour over the spacing: standard deviation over mean.
double variation_of_nearest(Points points, const Neighbours& neighbours, const std::vector<double>& spacing) {
  double count = 0, sum = 0, squares = 0;
  for (std::size_t i = 0; i < points.size(); i += stride_over(points.size())) {
    const double nearest = distance_to(points, neighbours, static_cast<Index>(i), 0) / spacing[i];
    count += 1;
    sum += nearest;
    squares += nearest * nearest;
  }
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) * count / sum;
}

// The value below which that share of others lies.
double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// By the quartiles, as of normal numbers.
double deviation_of(std::vector<double>& values) {
  const auto quartile = [&](std::size_t quarters) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(quarters * (values.size() - 1) / 4);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return (quartile(3) - quartile(1)) / 1.349;
}

}  // namespace

double noise_level(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                   const Run& run) {
  constexpr int count = 12;
  // Of normal noise: the roots of quantiles of the chi-square law over its freedom, 7.
  constexpr double quartile = 0.8, twentieth = 0.556;
  const std::size_t stride = stride_over(points.size());
  std::vector<double> deviation((points.size() - 1) / stride + 1);
  parallel_for_each(deviation.size(), Stage::Survey, run, [&](Index i) {
    const auto p = static_cast<Index>(stride * static_cast<std::size_t>(i));
    deviation[i] = fit_quadric(points, neighbours, p, count).deviation / spacing[p];
  });
  const double level = quantile(deviation, 0.25) / quartile;
  if (level == 0) return 0;
  const double is_everywhere = ramp(quantile(deviation, 0.05) / twentieth / level, 0.8, 0.9);
  const double is_close = ramp(variation_of_nearest(points, neighbours, spacing), 0.25, 0.28);
  return level * std::max(is_everywhere, is_close);
}

double irregularity(Points points, const Neighbours& neighbours, const std::vector<double>& spacing) {
  constexpr int far = 11, farthest = 39;
  const auto n = static_cast<std::size_t>(neighbours.size());
  if (neighbours.k <= far + 1) return 0;
  const int last = std::min(farthest, neighbours.k - 1);
  std::vector<double> crowding, reach;
  for (std::size_t i = 0; i < n; i += stride_over(n)) {
    const auto p = static_cast<Index>(i);
    const double twelfth = distance_to(points, neighbours, p, far);
    crowding.push_back(spacing[i] / twelfth);
    reach.push_back(std::log(twelfth / distance_to(points, neighbours, p, last)));
  }
  const auto middle = crowding.begin() + static_cast<std::ptrdiff_t>(crowding.size() / 2);
  std::nth_element(crowding.begin(), middle, crowding.end());
  const double by_nearest = ramp(variation_of_nearest(points, neighbours, spacing), 0.25, 0.3);
  const double by_crowding = ramp(-*middle, -0.55, -0.535);
  // At random areas to the twelfth and the fortieth have a ratio with the law of Beta(12, 28).
  const double at_random = 0.5 * std::sqrt(1 / (far + 0.5) - 1 / (static_cast<double>(last) + 0.5));
  const double by_count = ramp(deviation_of(reach) / at_random, 0.75, 0.85);
  return by_nearest * by_crowding * by_count;
}

double noise_weight(double level) {
  constexpr double least = 0.07, full = 0.09;
  return ramp(level, least, full);
}

std::vector<Point> take_off_noise(Points points, const Neighbours& neighbours, double weight,
                                  const Run& run) {
  constexpr int count = 24;
  std::vector<Point> moved(points.begin(), points.end());
  parallel_for_each(points.size(), Stage::Survey, run, [&](Index i) {
    const Quadric quadric = fit_quadric(points, neighbours, i, count);
    const Point there = points[i] + weight * quadric.height * quadric.normal;
    if (is_finite(there)) moved[i] = there;  // not where squares of the distances are no numbers any more
  });
  return moved;
}

}  // namespace rimline::exact
