// SPDX-License-Identifier: GPL-3.0-or-later
// The default method in place of sections 3 and 5: all loops of all components, each component a patch.
// [ours]
#include "base/vec.h"
#include "pipeline/given_loops.h"
#include "pipeline/loop_kinds.h"
#include "pipeline/mesh_patches.h"
#include "pipeline/method.h"
#include "pipeline/warnings.h"

namespace rimline::pipeline {
namespace {

SearchSummary summarize(SelectionSummary search) {
  SearchSummary summary;
  summary.doubtful = search.doubtful;
  summary.groups = search.groups;
  summary.greedy_fitness = search.greedy;
  summary.history = std::move(search.history);
  return summary;
}

std::vector<DoubtfulGap> with_places(const std::vector<Loop>& gaps, const std::vector<Point>& points) {
  std::vector<DoubtfulGap> found;
  for (const Loop& gap : gaps) {
    Point place;
    for (const Index v : gap.points)
      place = place + (1.0 / static_cast<double>(gap.points.size())) * points[v];
    found.push_back({gap.points.size(), gap.length, gap.probability, place});
  }
  return found;
}

// The search reports its progress as two stages; this tells the clock where the first of them ends.
Run with_clock(const Run& run, StageClock& clock) {
  Run timed = run;
  timed.on_progress = [&run, &clock](Progress progress) {
    if (progress.stage == Stage::Loops) clock.follow(Stage::Loops);
    if (run.on_progress) run.on_progress(progress);
  };
  return timed;
}

// In the order of the arrangement.
std::vector<RasterCell> raster_of(const Given& given, const PreparedPoints& prepared) {
  std::vector<RasterCell> cells;
  if (given.raster.empty()) return cells;
  for (const Index id : prepared.ids()) cells.push_back(given.raster[id]);
  return cells;
}

FoundLoops find_all_loops(const PreparedPoints& prepared, const BoundaryScores& scores,
                          const Options& options, const Given& given, const Run& run, StageClock& clock) {
  clock.enter(Stage::Survey);
  BoundaryLoops survey = with_ids_of_input(prepared, [&] {
    return find_boundary_loops(prepared.points(), prepared.neighbours, prepared.spacing, scores,
                               options.boundary_loops, options.loops.length_exponent, with_clock(run, clock),
                               raster_of(given, prepared));
  });
  FoundLoops found;
  found.probability = std::move(survey.probability);
  found.search = summarize(std::move(survey.search));
  if (!given.loops.empty()) {  // the triangles, which end at other loops, would tell the parts wrongly apart
    found.loops = with_one_outer_loop_a_part(arrange_loops(given.loops, prepared, scores, options.loops),
                                             prepared, run);
    found.label = label_boundary(std::move(survey.label), found.loops);
    return found;
  }
  found.doubtful = with_places(survey.doubtful, prepared.points());
  found.closed = survey.closed;
  if (survey.loops.empty() && !found.closed)
    found.warnings = {"no loop was found: the surface is closed, or its boundary can not be told"};
  for (std::string& warning : warn_of_doubtful(found.doubtful, options.boundary_loops))
    found.warnings.push_back(std::move(warning));
  found.loops = std::move(survey.loops);
  found.label = std::move(survey.label);
  found.surface = std::move(survey.triangles);
  found.range_scan = survey.range_scan;
  return found;
}

}  // namespace

const Method& default_method() {
  static constexpr Method method{find_all_loops, mesh_patches, mesh_patches};
  return method;
}

}  // namespace rimline::pipeline
