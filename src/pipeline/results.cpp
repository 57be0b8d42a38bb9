// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/results.h"

#include <algorithm>
#include <limits>

#include "parallel.h"
#include "rimline/loops.h"

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
  const Run silent = work.run.without_progress();  // the stages are over
  parallel_for_each(work.arrangement.ids.size(), Stage::Write, silent, [&](Index i) {
    const Index id = work.arrangement.ids[i];
    result.candidate[id] = work.scores.candidate[i];
    result.p_value[id] = p_value(work.scores.log_score[i]);
    result.score[id] = score(work.scores.log_score[i], work.options.loops.score_form);
    if (work.is_paper()) return;
    result.boundary_probability[id] = work.probability[i];
    result.label[id] = work.label[i];
  });
}

// From one value per vertex to one per point of the input, then per added one.
template <class T>
std::vector<T> of_input(const Work& work, const std::vector<T>& values, T unknown) {
  const std::vector<Index>& ids = work.arrangement.ids;
  std::vector<T> result(work.input.size(), unknown);
  for (std::size_t i = 0; i < std::min(ids.size(), values.size()); ++i) result[ids[i]] = values[i];
  if (values.size() > ids.size())
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(ids.size()), values.end());
  return result;
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

std::vector<Point> added_points(const Work& work) {
  std::vector<Point> added;
  for (std::size_t i = work.arrangement.points.size(); i < work.vertices.size(); ++i)
    added.push_back(work.vertices[i] + work.arrangement.origin);
  return added;
}

std::vector<UV> uv_of_input(const Work& work) { return of_input(work, work.uv, UV{nan, nan}); }

std::vector<Index> patch_of_input(const Work& work) {
  return work.patch.empty() ? std::vector<Index>{} : of_input(work, work.patch, none);
}

std::vector<Triangle> triangles_of_input(const Work& work) {
  std::vector<Triangle> triangles = work.triangles;
  const auto used = static_cast<Index>(work.arrangement.ids.size());
  const auto input = static_cast<Index>(work.input.size());
  for (Triangle& t : triangles) {
    for (Index& v : t) v = v < used ? work.arrangement.ids[v] : input + (v - used);
  }
  return triangles;
}

Distortion distortion_of_input(Work& work) {
  Distortion result = std::move(work.distortion);
  constexpr auto unknown = static_cast<float>(nan);
  for (auto* values :
       {&result.point.angle, &result.point.area, &result.point.stretch, &result.point.max_stretch}) {
    *values = of_input(work, *values, unknown);
  }
  return result;
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
