// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/results.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/parallel.h"
#include "rimline/unfilled.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The results of a point, in the order of the stages.
struct Record {
  double log_score;
  float probability;
  PointLabel label;
  std::uint8_t candidate;
};
constexpr Record left_out{nan, static_cast<float>(nan), PointLabel::Stray, 0};

// Puts results in the order of the input. One record a point is written, because each goes to another
// position in memory.
UnfilledVector<Record> records_of_input(const PreparedPoints& prepared, const BoundaryScores& scores,
                                        const std::vector<float>& probability,
                                        const std::vector<PointLabel>& label, const Run& run) {
  UnfilledVector<Record> records(prepared.input.size());
  const std::vector<Index>& ids = prepared.ids();
  if (ids.size() < records.size()) std::fill(records.begin(), records.end(), left_out);
  parallel_for_each(ids.size(), Stage::Write, run, [&](Index i) {
    Record x = left_out;
    x.log_score = scores.log_score[i];
    x.candidate = scores.candidate[i];
    if (!label.empty()) {
      x.probability = probability[i];
      x.label = label[i];
    }
    records[ids[i]] = x;
  });
  return records;
}

// An empty result for `points` points, of which those of `rated` have a probability and a label.
BoundaryResult make_room(std::size_t points, std::size_t rated, const Run& run) {
  BoundaryResult result;
  parallel_tasks(4, Stage::Write, run, [&](std::size_t k) {
    if (k == 0) result.p_value.resize(points);
    if (k == 1) result.score.resize(points);
    if (k == 2) result.loop.resize(points, none);
    if (k < 3) return;
    result.boundary.resize(points);
    result.candidate.resize(points);
    result.boundary_probability.resize(rated);
    result.label.resize(rated);
  });
  return result;
}

// The results of the test for each point.
BoundaryResult unpack(const UnfilledVector<Record>& records, bool rated, const LoopOptions& options,
                      const Run& run) {
  const std::size_t n = records.size();
  BoundaryResult result = make_room(n, rated ? n : 0, run);
  parallel_for_each(n, Stage::Write, run, [&](Index id) {
    const Record& x = records[id];
    const bool is_known = !std::isnan(x.log_score);
    result.p_value[id] = is_known ? p_value(x.log_score) : nan;
    result.score[id] = is_known ? score(x.log_score, options) : nan;
    result.candidate[id] = x.candidate;
    if (!rated) return;
    result.boundary_probability[id] = x.probability;
    result.label[id] = x.label;
  });
  return result;
}

// Translates one value per vertex to one per point of the input, then per added vertex.
template <class T>
std::vector<T> of_input(const PreparedPoints& prepared, const std::vector<T>& values, T unknown) {
  const std::vector<Index>& ids = prepared.ids();
  std::vector<T> result(prepared.input.size(), unknown);
  for (std::size_t i = 0; i < std::min(ids.size(), values.size()); ++i) result[ids[i]] = values[i];
  if (values.size() > ids.size())
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(ids.size()), values.end());
  return result;
}

// A shared point of two loops carries the id of the longer one.
BoundaryResult with_loops(BoundaryResult result, std::vector<Loop> loops) {
  for (Index l = 0; l < static_cast<Index>(loops.size()); ++l) {
    for (const Index id : loops[l].points) {
      result.boundary[id] = 1;
      Index& mark = result.loop[id];
      if (mark == none || loops[mark].length < loops[l].length) mark = l;
    }
  }
  result.loops = std::move(loops);
  return result;
}

}  // namespace

std::vector<Point> added_points(const PreparedPoints& prepared, const MappedMesh& mesh) {
  std::vector<Point> added;
  for (std::size_t i = prepared.points().size(); i < mesh.vertices.size(); ++i)
    added.push_back(mesh.vertices[i] + prepared.arrangement.origin);
  return added;
}

std::vector<UV> uv_of_input(const PreparedPoints& prepared, const std::vector<UV>& uv) {
  return of_input(prepared, uv, UV{nan, nan});
}

std::vector<Index> patch_of_input(const PreparedPoints& prepared, const std::vector<Index>& patch) {
  return patch.empty() ? std::vector<Index>{} : of_input(prepared, patch, none);
}

std::vector<Triangle> triangles_of_input(const PreparedPoints& prepared, std::vector<Triangle> triangles) {
  const std::vector<Index>& ids = prepared.ids();
  const auto used = static_cast<Index>(ids.size());
  const auto input = static_cast<Index>(prepared.input.size());
  for (Triangle& t : triangles) {
    for (Index& v : t) v = v < used ? ids[v] : input + (v - used);
  }
  return triangles;
}

Seams seams_of_input(const PreparedPoints& prepared, Seams seams) {
  const auto used = static_cast<Index>(prepared.ids().size());
  const auto left_out = static_cast<Index>(prepared.input.size()) - used;
  // Positions of seams follow the vertices, whose number grows by the points that are not in use.
  seams.corners = triangles_of_input(prepared, std::move(seams.corners));
  for (Index& v : seams.point) v = v < used ? prepared.ids()[v] : v + left_out;
  return seams;
}

Distortion distortion_of_input(const PreparedPoints& prepared, Distortion distortion) {
  constexpr auto unknown = static_cast<float>(nan);
  Distortion::Values& point = distortion.point;
  for (auto* values : {&point.angle, &point.area, &point.stretch, &point.max_stretch})
    *values = of_input(prepared, *values, unknown);
  return distortion;
}

BoundaryResult boundary_of_input(const PreparedPoints& prepared, const BoundaryScores& scores,
                                 const FoundLoops& found, const std::vector<PointLabel>& label,
                                 std::vector<Loop> loops, const LoopOptions& options, const Run& run) {
  const Run silent = run.without_progress();  // a short step
  const auto records = records_of_input(prepared, scores, found.probability, label, silent);
  for (Loop& loop : loops) {
    for (Index& id : loop.points) id = prepared.ids()[id];
  }
  BoundaryResult result = with_loops(unpack(records, !label.empty(), options, silent), std::move(loops));
  if (found.winner.empty()) return result;
  result.chromosome.assign(prepared.input.size(), 0);
  for (const Index i : found.winner) result.chromosome[prepared.ids()[i]] = 1;
  result.history = found.history;
  result.history.rename(prepared.ids());
  return result;
}

}  // namespace rimline::pipeline
