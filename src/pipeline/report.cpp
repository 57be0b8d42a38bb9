// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/report.h"

#include <algorithm>

#include "base/threads.h"
#include "pipeline/score.h"

namespace rimline::pipeline {
namespace {

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

PointCounts count_points(const PreparedPoints& prepared) {
  const Arrangement& a = prepared.arrangement;
  return {prepared.input.size(), a.points.size(), a.not_finite.size(), a.duplicates.size(), a.stray.size()};
}

// The paper's by-product (section 6): candidates that are not on the boundary. Ours has a label for them.
std::size_t count_undersampled(const BoundaryResult& result) {
  if (!result.label.empty())
    return std::count(result.label.begin(), result.label.end(), PointLabel::Undersampled);
  std::size_t count = 0;
  for (std::size_t i = 0; i < result.candidate.size(); ++i)
    count += result.candidate[i] && !result.boundary[i];
  return count;
}

}  // namespace

Report report_boundary(const PreparedPoints& prepared, const BoundaryScores& scores, const FoundLoops& found,
                       const Options& options, const Run& run) {
  const int k = std::min(options.boundary.k, prepared.neighbours.k);
  Report report;
  report.options = options;
  report.seed = run.seed;
  report.points = count_points(prepared);
  report.spacing = prepared.spacing_summary;
  report.steps = prepared.steps;
  report.assumptions = summarize_assumptions(scores, k, options.boundary.sectors);
  report.candidates = std::count(scores.candidate.begin(), scores.candidate.end(), 1);
  report.search = found.search;
  report.doubtful = found.doubtful;
  report.closed = found.closed;
  append(report.warnings, warn_of_assumptions(report.assumptions, k, options.boundary.sectors));
  append(report.warnings, found.warnings);
  return report;
}

Report add_map(Report report, const MappedMesh& mesh) {
  report.has_map = true;
  report.map = mesh.map;
  report.components = mesh.components;
  report.holes = mesh.holes;
  report.left_out = mesh.left_out;
  append(report.warnings, mesh.warnings);
  return report;
}

Report add_measures(Report report, const Measures& measures) {
  report.has_mesh = true;
  report.mesh = measures.mesh;
  report.distortion = measures.distortion.whole;
  report.components = measures.components;
  report.self_intersections = measures.self_intersections;
  report.more_self_intersections = measures.more_self_intersections;
  report.longest_edge = measures.longest_edge;
  report.reference = measures.reference;
  report.points.unmeshed = measures.unmeshed;
  append(report.warnings, measures.warnings);
  return report;
}

Report finish(Report report, const BoundaryResult& result, const Run& run, StageClock& clock) {
  report.loops = result.loops;
  report.undersampled = count_undersampled(result);
  report.threads = thread_count(run);
  clock.leave();
  report.stages = clock.costs();
  return report;
}

}  // namespace rimline::pipeline
