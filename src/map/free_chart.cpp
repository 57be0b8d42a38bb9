// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/free_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vec.h"
#include "map/conformal_descent.h"
#include "map/domain.h"
#include "map/embed.h"
#include "map/free_map.h"
#include "map/outline_crossings.h"
#include "map/outline_first.h"
#include "solve/sparse.h"

namespace rimline {
namespace {

constexpr double flat_mean = 1.05;  // bound of conformal_distortion(): above it, triangles are nearly flat

// Whether all triangles keep a height when the chart is moved.
bool have_height(const OpenMesh& open, const std::vector<UV>& uv) {
  constexpr double least = 1e-9;  // of the longest side
  return std::ranges::all_of(open.mesh.triangles,
                             [&](const Triangle& t) { return has_height(uv, t, least); });
}

bool is_valid(const OpenMesh& open, const std::vector<UV>& uv) {
  return have_height(open, uv) && crossing_points(open.loops, uv).empty();
}

bool is_good(const OpenMesh& open, const std::vector<UV>& uv) {
  return is_valid(open, uv) && conformal_distortion(open.points, open.mesh, uv) <= flat_mean;
}

// Scales to the area of the surface, or, nearly without area, to the length of the outline.
void scale_chart(const OpenMesh& open, std::vector<UV>& uv) {
  constexpr double thin = 1e-8;  // of the square of the outline's length
  const Loop& outline = open.loops.front();
  double area = 0, length = 0;
  for (const Triangle& t : open.mesh.triangles) area += triangle_area(open.points, t);
  if (area > thin * outline.length * outline.length) return scale_to_area(open.points, open.mesh, uv);
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const UV a = uv[outline.points[i]], b = uv[outline.points[next_in(i, outline.points.size())]];
    length += std::hypot(b.u - a.u, b.v - a.v);
  }
  for (UV& p : uv) p = {outline.length / length * p.u, outline.length / length * p.v};
}

ChartMap laid_out(const OpenMesh& open, std::vector<UV> uv, const MapSummary& summary) {
  lay_level(open.points, open.loops.front().points, uv);
  scale_chart(open, uv);
  return {std::move(uv), Domain::Free, summary};
}

int steps_of(const OpenMesh& open, const ChartEffort& effort) {
  constexpr std::int64_t most = 100;
  if (effort.work == ChartEffort{}.work) return most_descent_steps(open.mesh.triangles.size());
  return static_cast<int>(std::min(most, effort.work / std::max<std::int64_t>(1, open.mesh.size())));
}

bool descends(const OpenMesh& open, const ChartEffort& effort) {
  constexpr int few = 5;  // steps that lead nowhere
  return steps_of(open, effort) >= few;
}

// Descends from a valid map.
FreeChart relaxed(const OpenMesh& open, std::vector<UV> uv, const MapSummary& summary,
                  const ChartEffort& effort, const Run& run) {
  if (!is_valid(open, uv)) return {};
  scale_chart(open, uv);
  const DescentOptions options{effort.isometry, steps_of(open, effort)};
  const int steps = relax_conformally(open.points, open.mesh, open.loops, options, uv, run);
  FreeChart chart{{}, steps * static_cast<std::int64_t>(open.mesh.triangles.size())};
  if (is_valid(open, uv)) chart.map = laid_out(open, std::move(uv), summary);
  return chart;
}

// Within the outline that `uv` has.
FreeChart anew_within(const OpenMesh& open, std::vector<UV> uv, double residual, const ChartEffort& effort,
                      const Run& run) {
  constexpr int repairs = 5;
  constexpr double least = 1e-6;  // height of a triangle from which a descent gets on
  if (!crossing_points({open.loops.front()}, uv).empty()) return {};
  uv.resize(open.points.size() + open.loops.size() - 1);
  const Embedding inside = embed(open.points, open.mesh, open.loops, residual, repairs, uv, run, least);
  uv.resize(open.points.size());
  if (!have_height(open, uv)) return {};
  if (is_good(open, uv)) return {laid_out(open, std::move(uv), inside.map)};
  if (!descends(open, effort)) return {};
  return relaxed(open, std::move(uv), inside.map, effort, run);
}

std::optional<ChartMap> to_disc(const OpenMesh& open, double residual, const Run& run) {
  constexpr int repairs = 8;
  std::vector<UV> uv(open.points.size() + open.loops.size() - 1);
  place_outline(open.points, open.loops.front().points, Domain::Disc, std::array{none, none, none, none}, uv);
  const Embedding disc = embed(open.points, open.mesh, open.loops, residual, repairs, uv, run);
  if (disc.flips > 0) return {};
  uv.resize(open.points.size());
  scale_chart(open, uv);
  return ChartMap{std::move(uv), Domain::Disc, disc.map};
}

// Nothing where a system could not be solved.
template <class Map>
auto where_solved(const Map& map) -> decltype(map()) {
  try {
    return map();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::NoConvergence) throw;
    return {};
  }
}

std::optional<ChartMap> outline_first(const OpenMesh& open, const std::vector<double>& turning,
                                      double residual, const Run& run) {
  std::vector<UV> uv;
  const MapSummary summary = map_outline_first(open, turning, residual, uv, run);
  if (!is_good(open, uv)) return {};
  return laid_out(open, std::move(uv), summary);
}

FreeChart first_good(const OpenMesh& open, const std::vector<double>& turning, double residual,
                     const ChartEffort& effort, const Run& run) {
  constexpr Index large = 30'000, too_large = 200'000;  // vertices: for least squares at first, and at all
  constexpr double little = 1e-3;                       // then no inner edge without a weight
  std::vector<UV> uv;
  if (open.vertices() > large && !turning.empty()) {
    if (auto map = outline_first(open, turning, residual, run)) return {std::move(map)};
    if (!descends(open, effort) || open.vertices() > too_large) return {};
  }
  for (const double least : {0.0, little}) {
    const MapSummary summary = free_map(open.points, open.mesh, open.loops.front().points, least, uv, run);
    if (is_good(open, uv)) return {laid_out(open, std::move(uv), summary)};
    if (have_height(open, uv)) break;
  }
  FreeChart chart = where_solved([&] { return anew_within(open, uv, residual, effort, run); });
  if (chart.map || !descends(open, effort)) return chart;
  const auto disc = to_disc(open, residual, run);
  if (!disc) return chart;
  const std::int64_t before = chart.work;
  chart = relaxed(open, disc->uv, disc->summary, effort, run);
  chart.work += before;
  return chart;
}

}  // namespace

std::optional<ChartMap> disc_chart(const OpenMesh& open, double residual, const Run& run) {
  return where_solved([&] { return to_disc(open, residual, run); });
}

std::optional<ChartMap> given_chart(const OpenMesh& open, std::vector<UV> uv) {
  if (!is_valid(open, uv)) return {};
  return laid_out(open, std::move(uv), {});
}

FreeChart free_chart(const OpenMesh& open, const std::vector<double>& turning, double residual,
                     const ChartEffort& effort, const Run& run) {
  return where_solved([&] { return first_good(open, turning, residual, effort, run); });
}

std::optional<ChartMap> outline_first_chart(const OpenMesh& open, const std::vector<double>& turning,
                                            double residual, const Run& run) {
  return where_solved([&] { return outline_first(open, turning, residual, run); });
}

FreeChart evened_chart(const OpenMesh& open, const ChartMap& from, const ChartEffort& effort,
                       const Run& run) {
  return where_solved([&] { return relaxed(open, from.uv, from.summary, effort, run); });
}

}  // namespace rimline
