// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/results.h"

#include <fmt/format.h>

#include <limits>

#include "parallel.h"
#include "rimline/loops.h"
#include "rimline/measure.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What the tests say of each point.
void put_points(const Work& work, BoundaryResult& result) {
  const std::size_t n = work.input.size();
  result.boundary.assign(n, 0);
  result.loop.assign(n, none);
  result.candidate.assign(n, 0);
  result.p_value.assign(n, nan);
  result.score.assign(n, nan);
  if (!work.is_paper()) {
    result.boundary_probability.assign(n, static_cast<float>(nan));
    result.label.assign(n, PointLabel::Stray);
  }
  for (std::size_t i = 0; i < work.arrangement.ids.size(); ++i) {
    const Index id = work.arrangement.ids[i];
    result.candidate[id] = work.scores.candidate[i];
    result.p_value[id] = p_value(work.scores.log_score[i]);
    result.score[id] = score(work.scores.log_score[i], work.options.loops.score_form);
    if (work.is_paper()) continue;
    result.boundary_probability[id] = work.probability[i];
    result.label[id] = work.label[i];
  }
}

// A point that two loops share carries the id of the longer one.
void mark_loops(const std::vector<Loop>& loops, BoundaryResult& result) {
  for (Index l = 0; l < static_cast<Index>(loops.size()); ++l) {
    for (const Index id : loops[l].points) {
      result.boundary[id] = 1;
      Index& mark = result.loop[id];
      if (mark == none || loops[mark].length < loops[l].length) mark = l;
    }
  }
}

// The paper's by-product (section 6): candidates that are not on the boundary. Ours has a label for them.
std::size_t count_undersampled(const Work& work, const BoundaryResult& result) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < work.input.size(); ++i) {
    count += work.is_paper() ? result.candidate[i] && !result.boundary[i]
                             : result.label[i] == PointLabel::Undersampled;
  }
  return count;
}

}  // namespace

void measure(Work& work) {
  work.clock.enter(Stage::Measure);
  Report& report = work.report;
  report.has_mesh = true;
  report.mesh = measure_mesh(work.arrangement.points, work.triangles, work.spacing, work.uv, work.run);
  report.points.unmeshed = work.arrangement.points.size() - report.mesh.points_used;
  if (report.points.unmeshed > 0) {
    report.warnings.push_back(
        work.is_paper() ? fmt::format("{} points fell on others in the plane and are in no triangle",
                                      report.points.unmeshed)
                        : fmt::format("{} points hang together with no loop and are in no triangle",
                                      report.points.unmeshed));
  }
}

std::vector<UV> uv_of_input(const Work& work) {
  std::vector<UV> uv(work.input.size(), UV{nan, nan});
  for (std::size_t i = 0; i < work.uv.size(); ++i) uv[work.arrangement.ids[i]] = work.uv[i];
  return uv;
}

std::vector<Index> patch_of_input(const Work& work) {
  if (work.patch.empty()) return {};
  std::vector<Index> patch(work.input.size(), none);
  for (std::size_t i = 0; i < work.patch.size(); ++i) patch[work.arrangement.ids[i]] = work.patch[i];
  return patch;
}

std::vector<Triangle> triangles_of_input(const Work& work) {
  std::vector<Triangle> triangles = work.triangles;
  for (Triangle& t : triangles) {
    for (Index& id : t) id = work.arrangement.ids[id];
  }
  return triangles;
}

BoundaryResult boundary_result(Work& work) {
  BoundaryResult result;
  put_points(work, result);
  for (Loop& loop : work.loops) {
    for (Index& id : loop.points) id = work.arrangement.ids[id];
  }
  mark_loops(work.loops, result);
  Report& report = work.report;
  report.undersampled = count_undersampled(work, result);
  work.clock.leave();
  report.options = work.options;
  report.seed = work.run.seed;
  report.loops = work.loops;
  report.threads = thread_count(work.run);
  report.stages = work.clock.costs();
  result.loops = std::move(work.loops);
  result.report = std::move(report);
  return result;
}

}  // namespace rimline::pipeline
