// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/score.h"

#include <fmt/format.h>

#include <algorithm>

namespace rimline::pipeline {
namespace {

// All points lie on a line: there is no tangent plane, and the result would be rounding error.
void check_not_on_lines(const BoundaryScores& scores) {
  constexpr float least = 1e-12F;  // of the variability: a millionth of the width, still far above rounding
  const auto& delta = scores.delta;
  if (std::any_of(delta.begin(), delta.end(), [](float d) { return d > least; })) return;
  throw Error(ErrorCode::NoClosedLoop,
              "no closed loop: the points lie on a line, or on several far apart, not on a surface");
}

}  // namespace

BoundaryScores score(const PreparedPoints& prepared, const Options& options, const Run& run,
                     StageClock& clock) {
  clock.enter(Stage::Boundary);
  BoundaryScores scores = score_boundary(prepared.points(), prepared.neighbours, options.boundary, run);
  check_not_on_lines(scores);
  return scores;
}

AssumptionSummary summarize_assumptions(const BoundaryScores& scores, int k, int sectors) {
  AssumptionSummary a;
  a.delta = *std::min_element(scores.delta.begin(), scores.delta.end());
  a.below_delta = std::count_if(scores.delta.begin(), scores.delta.end(), [](float d) { return d < 0.05f; });
  a.points_per_sector = static_cast<double>(k) / sectors;
  a.chi_square_valid = a.points_per_sector >= 5;
  return a;
}

std::vector<std::string> warn_of_assumptions(const AssumptionSummary& assumptions, int k, int sectors) {
  if (assumptions.chi_square_valid) return {};
  return {
      fmt::format("{} neighbours over {} sectors are {:.3g} a sector; the chi-square law wants at least "
                  "5 (section 2.3)",
                  k, sectors, assumptions.points_per_sector)};
}

}  // namespace rimline::pipeline
