// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/fitness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vec.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

// log of the sum of the scores, from the logarithm of each, without overflow.
double log_sum(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options) {
  if (options.score_form == ScoreForm::Log) {
    double sum = 0;
    for (const Index i : ids) sum += scores.log_score[i];
    return std::log(sum);
  }
  double largest = 0;
  for (const Index i : ids) largest = std::max(largest, log_of_score(scores.log_score[i], options));
  double sum = 0;
  for (const Index i : ids) sum += std::exp(log_of_score(scores.log_score[i], options) - largest);
  return largest + std::log(sum);
}

}  // namespace

// Equation (3): the sum of the scores over (number of boundary vertices)^(9/10).
double log_fitness(std::span<const Index> ids, const BoundaryScores& scores, const LoopOptions& options) {
  if (ids.empty()) return -std::numeric_limits<double>::infinity();
  return log_sum(ids, scores, options) - options.length_exponent * std::log(static_cast<double>(ids.size()));
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
