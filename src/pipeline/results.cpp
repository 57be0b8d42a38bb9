// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/results.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "parallel.h"
#include "rimline/loops.h"
#include "rimline/unfilled.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What is told of a point, as the stages have it.
struct Told {
  double log_score;
  float probability;
  PointLabel label;
  std::uint8_t candidate;
};
constexpr Told left_out{nan, static_cast<float>(nan), PointLabel::Stray, 0};

// In the order of the input. Put there as one record a point, since each goes to another place in memory.
UnfilledVector<Told> told_of_input(const Work& work, const Run& run) {
  UnfilledVector<Told> told(work.input.size());
  const std::vector<Index>& ids = work.arrangement.ids;
  if (ids.size() < told.size()) std::fill(told.begin(), told.end(), left_out);
  parallel_for_each(ids.size(), Stage::Write, run, [&](Index i) {
    Told x = left_out;
    x.log_score = work.scores.log_score[i];
    x.candidate = work.scores.candidate[i];
    if (!work.is_paper()) {
      x.probability = work.probability[i];
      x.label = work.label[i];
    }
    told[ids[i]] = x;
  });
  return told;
}

// What the tests say of each point.
void put_points(const Work& work, BoundaryResult& result) {
  const std::size_t n = work.input.size();
  const Run silent = work.run.without_progress();  // takes a moment
  const UnfilledVector<Told> told = told_of_input(work, silent);
  const std::size_t rated = work.is_paper() ? 0 : n;
  parallel_tasks(4, Stage::Write, silent, [&](std::size_t k) {
    if (k == 0) result.p_value.resize(n);
    if (k == 1) result.score.resize(n);
    if (k == 2) result.loop.resize(n, none);
    if (k < 3) return;
    result.boundary.resize(n);
    result.candidate.resize(n);
    result.boundary_probability.resize(rated);
    result.label.resize(rated);
  });
  parallel_for_each(n, Stage::Write, silent, [&](Index id) {
    const Told& x = told[id];
    const bool is_told = !std::isnan(x.log_score);
    result.p_value[id] = is_told ? p_value(x.log_score) : nan;
    result.score[id] = is_told ? score(x.log_score, work.options.loops.score_form) : nan;
    result.candidate[id] = x.candidate;
    if (rated == 0) return;
    result.boundary_probability[id] = x.probability;
    result.label[id] = x.label;
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
