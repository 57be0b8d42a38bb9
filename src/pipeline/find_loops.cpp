// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/find_loops.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/given_loops.h"
#include "rimline/loops.h"

namespace rimline::pipeline {
namespace {

void report_assumptions(Work& work) {
  const BoundaryScores& scores = work.scores;
  AssumptionSummary& a = work.report.assumptions;
  a.delta = *std::min_element(scores.delta.begin(), scores.delta.end());
  a.below_delta = std::count_if(scores.delta.begin(), scores.delta.end(), [](float d) { return d < 0.05f; });
  const int k = std::min(work.options.boundary.k, work.neighbours.k);
  a.points_per_sector = static_cast<double>(k) / work.options.boundary.sectors;
  a.chi_square_valid = a.points_per_sector >= 5;
  if (!a.chi_square_valid) {
    work.report.warnings.push_back(
        fmt::format("{} neighbours over {} sectors are {:.3g} a sector; the chi-square law wants at least "
                    "5 (section 2.3)",
                    k, work.options.boundary.sectors, a.points_per_sector));
  }
  work.report.candidates = std::count(scores.candidate.begin(), scores.candidate.end(), 1);
}

// All neighbours of every point on one line: there is no plane to project them to, and what came out would be
// made of rounding.
void check_not_on_lines(const BoundaryScores& scores) {
  constexpr float least = 1e-12F;  // of the variability: a millionth of the width, still far above rounding
  const auto& delta = scores.delta;
  if (std::any_of(delta.begin(), delta.end(), [](float d) { return d > least; })) return;
  throw Error(ErrorCode::NoClosedLoop,
              "no closed loop: the points lie on a line, or on several far apart, not on a surface");
}

// Section 3, Algorithms 3.1 and 3.2.
void find_loop_of_the_paper(Work& work) {
  GeneticLoop found = translate_errors(work, [&] {
    return find_genetic_loop(work.arrangement.points, work.neighbours, work.scores, work.options.loops,
                             work.run);
  });
  Report& report = work.report;
  report.search = std::move(found.search);
  work.loops = {std::move(found.loop)};
  if (report.search.bound_hit) {
    report.warnings.push_back(fmt::format(
        "the search for closed paths stopped at its bound of {} steps after {} of {} candidates; raise "
        "max_path_steps to search them all",
        work.options.loops.max_path_steps, report.search.starts, report.candidates));
  }
}

// Ours: every loop of every component.
void find_all_loops(Work& work) {
  Run run = work.run;
  run.on_progress = [&](Progress progress) {  // which tells where the survey ends
    if (progress.stage == Stage::Loops) work.clock.follow(Stage::Loops);
    if (work.run.on_progress) work.run.on_progress(progress);
  };
  BoundarySurvey found = translate_errors(work, [&] {
    return find_exact_loops(work.arrangement.points, work.neighbours, work.spacing, work.scores,
                            work.options.exact, work.options.loops.length_exponent, run);
  });
  work.loops = std::move(found.loops);
  work.probability = std::move(found.probability);
  work.label = std::move(found.label);
  // Triangles that end at other loops than those given would tell the parts wrongly apart.
  if (work.given.loops.empty()) {
    work.surveyed = std::move(found.triangles);
    work.range_scan = found.range_scan;
  }
  SearchSummary& search = work.report.search;
  search.doubtful = found.search.doubtful;
  search.groups = found.search.groups;
  search.greedy_fitness = found.search.greedy;
  search.history = std::move(found.search.history);
  if (work.loops.empty() && work.given.loops.empty()) {
    work.report.warnings.push_back(
        "no loop was found: the surface is closed, or its boundary can not be told");
  }
}

}  // namespace

void find_loops(Work& work) {
  work.clock.enter(Stage::Boundary);
  work.scores = score_boundary(work.arrangement.points, work.neighbours, work.options.boundary, work.run);
  report_assumptions(work);
  check_not_on_lines(work.scores);
  work.clock.enter(work.is_paper() ? Stage::Loops : Stage::Survey);
  if (!work.is_paper()) {
    find_all_loops(work);
  } else if (work.given.loops.empty()) {
    find_loop_of_the_paper(work);
  }
  if (!work.given.loops.empty()) take_given_loops(work);
}

}  // namespace rimline::pipeline
