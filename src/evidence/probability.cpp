// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/probability.h"

#include <algorithm>
#include <cmath>

namespace rimline {
namespace {

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

// Angle by which the way a, b, c turns in the plane of b; positive to the left as the frame sees it.
double turning(const TriangleSet& set, Index a, Index b, Index c) {
  const Frame& f = set.frames()[b];
  const Points p = set.points();
  const Point in = p[b] - p[a], out = p[c] - p[b];
  const double x0 = dot(in, f.u), y0 = dot(in, f.v), x1 = dot(out, f.u), y1 = dot(out, f.v);
  return std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
}

double cost(double turn, const FitnessModel& w) {
  const double t = std::abs(turn);
  return w.slight * std::min(t, 0.3) + w.moderate * std::min(t, 0.7) + w.sharp * t;
}

}  // namespace

double ear_log_odds(const TriangleSet& set, const LocalSizes& sizes, const FitnessModel& weights,
                    const std::array<Index, 5>& run) {
  const auto [before, a, b, c, after] = run;
  const Triangle triangle{a, b, c};
  const double ratio = sizes.log_ratio(triangle);
  double largest = 0;
  for (const Index v : triangle) largest = std::max(largest, sizes.own(v));
  const Points p = set.points();
  const double own = std::clamp(std::log(circumradius(p[a], p[b], p[c]) / largest), -1.0, 3.0);
  const double open = cost(turning(set, before, a, b), weights) + cost(turning(set, a, b, c), weights) +
                      cost(turning(set, b, c, after), weights);
  const double filled = cost(turning(set, before, a, c), weights) + cost(turning(set, a, c, after), weights);
  return weights.open + weights.size * ratio + weights.own * own - open + filled;
}

double false_ear_log_odds(const TriangleSet& set, const LocalSizes& sizes, const CornerHistogram& usual,
                          const Triangle& ear, double jaggedness) {
  const Points p = set.points();
  const double angle = angle_at(p[ear[0]], p[ear[1]], p[ear[2]]);
  return -6.69 + 1.56 * angle + 0.42 * usual.log_tail(angle, sizes.log_ratio(ear)) + 1.79 * jaggedness;
}

double loop_probability(std::size_t points, double empty_ball, double thickness) {
  const double size = std::log(std::min(24.0, static_cast<double>(points)) / 12);
  return logistic(-2.4 + 0.76 * size - 4.3 * thickness + 3.1 * std::min(empty_ball, 3.0));
}

double thickness_of_opening(std::size_t points) { return 4 / std::pow(static_cast<double>(points), 1.5); }

double no_gap(double isoperimetric_ratio) { return std::pow(std::min(1.0, isoperimetric_ratio), 2); }

double range_image_loop_probability(std::size_t points) {
  const double n = static_cast<double>(points);
  return n / (n + 2);
}

double point_probability(double ear, bool on_rim, double chi_square_score, double loop_probability) {
  const double chi = std::log1p(chi_square_score);
  const double p = std::clamp(loop_probability, 0.01, 0.99), rim = std::log(p / (1 - p));
  const double point = on_rim ? logistic(-2.51 + 0.11 * std::clamp(ear, -4.0, 8.0) + 1.36 * chi + 0.68 * rim)
                              : logistic(-3.7 + 0.40 * std::clamp(ear, -10.0, 4.0) + 1.94 * chi + 0.10 * rim);
  return point * std::min(1.0, 2 * p);  // creases and thin walls score high too
}

double jagged_point_probability(double log_odds, double jaggedness, double loop_probability) {
  return jaggedness * logistic(log_odds) * std::min(1.0, 2 * loop_probability);
}

double behind_jagged_point(double jaggedness, double loop_probability) {
  constexpr double measured = 0.037;  // of 2,912 such points of known sets
  return jaggedness * measured * std::min(1.0, 2 * loop_probability);
}

double on_jagged_rim(double jaggedness, double loop_probability) {
  constexpr double measured = 0.77;  // of 753 points of cuts that would have less than 0.8
  return jaggedness * measured * loop_probability;
}

double at_cut_probability(double jaggedness, double loop_probability) {
  constexpr double measured = 0.14;  // of 396 such points of 45 cuts
  return jaggedness * measured * std::min(1.0, 2 * loop_probability);
}

double blurred_log_odds(double depth, double noise) {
  constexpr double sharpest = 0.06;  // square of how far off the line may be without noise, in spacings
  return depth / (sharpest + 1.6 * noise * noise);
}

double blurred_probability(double depth, double noise, double loop_probability) {
  return logistic(blurred_log_odds(depth, noise)) *
         std::min(1.0, 2 * std::clamp(loop_probability, 0.01, 0.99));
}

double range_image_point_probability(bool on_rim, double chi_square_score, double loop_probability) {
  if (!on_rim) return 0.12;  // measured: 0.06 to 0.12, whatever the score
  return logistic(0.5 + 0.95 * std::log1p(chi_square_score)) * std::min(1.0, 2 * loop_probability);
}

float range_image_isolated_probability() { return 0.3F; }

double far_from_rims() { return 0.001; }

}  // namespace rimline
