// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/probability.h"

#include <algorithm>
#include <cmath>

#include "base/model.h"

namespace rimline {
namespace {

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

// The turning angle of the path a, b, c in the plane of b; positive to the left as the frame sees it.
double turning(const TriangleSet& set, Index a, Index b, Index c) {
  const Frame& f = set.frames()[b];
  const Points p = set.points();
  const Point in = p[b] - p[a], out = p[c] - p[b];
  const double x0 = dot(in, f.u), y0 = dot(in, f.v), x1 = dot(out, f.u), y1 = dot(out, f.v);
  return std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
}

double cost(double turn, const model::FitnessModel& w) {
  const double t = std::abs(turn);
  return w.slight * std::min(t, model::turn_slight) + w.moderate * std::min(t, model::turn_moderate) +
         w.sharp * t;
}

}  // namespace

double ear_log_odds(const TriangleSet& set, const LocalSizes& sizes, const model::FitnessModel& weights,
                    const std::array<Index, 5>& run) {  // [layout]
  const auto [before, a, b, c, after] = run;
  const Triangle triangle{a, b, c};
  const double ratio = sizes.log_ratio(triangle);
  double largest = 0;
  for (const Index v : triangle) largest = std::max(largest, sizes.own(v));
  const Points p = set.points();
  const double own =
      std::clamp(std::log(circumradius(p[a], p[b], p[c]) / largest), model::own_least, model::own_most);
  const double open = cost(turning(set, before, a, b), weights) + cost(turning(set, a, b, c), weights) +
                      cost(turning(set, b, c, after), weights);
  const double filled = cost(turning(set, before, a, c), weights) + cost(turning(set, a, c, after), weights);
  return weights.open + weights.size * ratio + weights.own * own - open + filled;
}

FalseEarMeasures measure_false_ear(const TriangleSet& set, const LocalSizes& sizes,
                                   const CornerHistogram& corners, const Triangle& ear, double jaggedness) {
  const Points p = set.points();
  const double angle = angle_at(p[ear[0]], p[ear[1]], p[ear[2]]);
  return {angle, corners.log_tail(angle, sizes.log_ratio(ear)), jaggedness};
}

double false_ear_log_odds(const FalseEarMeasures& x) {
  const model::FalseEarModel& m = model::false_ear;
  return m.constant + m.angle * x.angle + m.log_tail * x.log_tail + m.jaggedness * x.jaggedness;
}

double loop_probability(std::size_t points, double empty_ball, double thickness) {
  const model::RimModel& m = model::rim;
  const double size = std::log(std::min(m.most_points, static_cast<double>(points)) / m.usual_points);
  return logistic(m.constant + m.size * size + m.thickness * thickness +
                  m.empty_ball * std::min(empty_ball, m.most_ball));
}

double thickness_of_opening(std::size_t points) {
  return model::opening_thickness / std::pow(static_cast<double>(points), 1.5);  // [layout] the law
}

double no_gap(double isoperimetric_ratio) { return std::pow(std::min(1.0, isoperimetric_ratio), 2); }

double range_image_loop_probability(std::size_t points, double one_sided) {
  const model::RangeRimModel& m = model::range_rim;
  const double size = std::log(std::min(static_cast<double>(points), m.most_points) / m.usual_points);
  return logistic(m.constant + m.size * size + m.one_sided * one_sided);
}

double point_probability(double ear, bool on_rim, double chi_square_score, double loop_probability) {
  const double chi = std::log1p(chi_square_score);
  const double p = std::clamp(loop_probability, model::rim_least, model::rim_most),
               rim = std::log(p / (1 - p));
  const auto point = [&](const auto& m) {
    return logistic(m.constant + m.ear * std::clamp(ear, m.least_ear, m.most_ear) + m.chi * chi +
                    m.rim * rim);
  };
  return (on_rim ? point(model::point_on_rim) : point(model::point_behind_rim)) *
         std::min(1.0, 2 * p);  // creases and thin walls have high scores, too
}

double jagged_point_probability(double log_odds, double jaggedness, double loop_probability) {
  return jaggedness * logistic(log_odds) * std::min(1.0, 2 * loop_probability);
}

double behind_jagged_point(double jaggedness, double loop_probability) {
  return jaggedness * model::behind_jagged * std::min(1.0, 2 * loop_probability);
}

double on_jagged_rim(double jaggedness, double loop_probability) {
  return jaggedness * model::on_jagged * loop_probability;
}

double at_cut_probability(double jaggedness, double loop_probability) {
  return jaggedness * model::at_cut * std::min(1.0, 2 * loop_probability);
}

double blurred_log_odds(double depth, double noise) {
  return depth / (model::blur_sharpest + model::blur_noise * noise * noise);
}

double blurred_probability(double depth, double noise, double loop_probability) {
  return logistic(blurred_log_odds(depth, noise)) *
         std::min(1.0, 2 * std::clamp(loop_probability, model::rim_least, model::rim_most));
}

double range_image_point_probability(bool on_rim, double chi_square_score, double loop_probability) {
  if (!on_rim) return model::range_point_behind;
  return logistic(model::range_point_constant + model::range_point_chi * std::log1p(chi_square_score)) *
         std::min(1.0, 2 * loop_probability);
}

float range_image_isolated_probability() { return model::range_point_alone; }

double far_from_rims() { return model::far_from_rims; }

}  // namespace rimline
