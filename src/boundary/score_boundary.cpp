// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/score_boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/parallel.h"
#include "boundary/chi_square.h"
#include "boundary/sectors.h"
#include "local/neighbourhood.h"

namespace rimline {
namespace {

// Eq. (1) depends on the counts only through the sum of their squares, a whole number: the statistic is
// r / k times it, less k. So p-values come from a table with one entry for each sum that can occur.
std::vector<double> log_score_table(int k, int sectors) {
  std::vector<double> table(static_cast<std::size_t>(k) * k + 1);
  for (std::size_t squares = 0; squares < table.size(); ++squares) {
    const double statistic = static_cast<double>(sectors) * static_cast<double>(squares) / k - k;
    table[squares] = negative_log_survival(statistic, sectors - 1);
  }
  return table;
}

// At most k * k, the sum for k points in one sector. Where products underflow, a point may be counted in
// three sectors and subtracted from a fourth.
std::size_t sum_of_squares(const std::vector<Lanes>& counts, int l, int k) {
  double sum = 0;
  for (const Lanes& count : counts) sum += count[l] * count[l];
  return std::min(static_cast<std::size_t>(sum), static_cast<std::size_t>(k) * k);
}

}  // namespace

BoundaryScores score_boundary(Points points, const Neighbours& neighbours, const BoundaryOptions& options,
                              const Run& run) {
  const int k = std::min(options.k, neighbours.k);
  if (k < 3) {
    throw Error(ErrorCode::TooFewPoints, "the boundary test needs at least 4 distinct points, there are " +
                                             std::to_string(points.size()));
  }
  const std::vector<double> log_score_of = log_score_table(k, options.sectors);
  const Sectors sectors(options.sectors);
  const double log_significance = -std::log(options.significance);
  BoundaryScores result;
  result.log_score.resize(points.size());
  result.candidate.resize(points.size());
  result.delta.resize(points.size());
  parallel_slices(points.size(), Stage::Boundary, run, [&](std::size_t begin, std::size_t end) {
    Neighbourhoods neighbourhoods(k);
    PrincipalAxesLanes axes;
    std::vector<Lanes> counts(options.sectors);
    for (auto first = static_cast<Index>(begin); first < static_cast<Index>(end); first += lanes) {
      neighbourhoods.gather(points, neighbours, first, static_cast<Index>(end));
      neighbourhoods.find_axes(axes);
      neighbourhoods.flatten(axes);
      sectors.count(neighbourhoods.u(), neighbourhoods.v(), counts);
      for (Index i = first; i < std::min(first + lanes, static_cast<Index>(end)); ++i) {
        result.log_score[i] = log_score_of[sum_of_squares(counts, i - first, k)];
        result.candidate[i] = result.log_score[i] >= log_significance;
        result.delta[i] = static_cast<float>(delta(axes.of(i - first)));
      }
    }
  });
  return result;
}

double p_value(double log_score) { return std::exp(-log_score); }

double log_of_score(double log_score, const LoopOptions& options) {
  switch (options.score_form) {
    case ScoreForm::Printed: return log_score;
    case ScoreForm::Capped: return std::min(log_score, -std::log(options.score_cap));
    case ScoreForm::Log: return std::log(log_score);
  }
  return log_score;
}

double score(double log_score, const LoopOptions& options) {
  if (options.score_form == ScoreForm::Log) return log_score;
  return std::min(std::exp(log_of_score(log_score, options)), std::numeric_limits<double>::max());
}

}  // namespace rimline
