// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/fitness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vec.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

// log of the sum of 1 / p, from -log p, without overflow.
double log_sum_printed(std::span<const Index> ids, const std::vector<double>& log_score) {
  double largest = 0;
  for (const Index i : ids) largest = std::max(largest, log_score[i]);
  double sum = 0;
  for (const Index i : ids) sum += std::exp(log_score[i] - largest);
  return largest + std::log(sum);
}

double log_sum_log(std::span<const Index> ids, const std::vector<double>& log_score) {
  double sum = 0;
  for (const Index i : ids) sum += log_score[i];
  return std::log(sum);
}

}  // namespace

// Equation (3): the sum of the scores over (number of boundary vertices)^(9/10).
double log_fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options) {
  if (ids.empty()) return -std::numeric_limits<double>::infinity();
  const double log_sum = options.score_form == ScoreForm::Printed ? log_sum_printed(ids, scores.log_score)
                                                                  : log_sum_log(ids, scores.log_score);
  return log_sum - options.length_exponent * std::log(static_cast<double>(ids.size()));
}

double fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options) {
  return std::min(std::exp(log_fitness(ids, scores, options)), std::numeric_limits<double>::max());
}

double loop_length(Points points, std::span<const Index> loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += distance(points[loop[i]], points[loop[next_in(i, loop.size())]]);
  }
  return length;
}

}  // namespace rimline
