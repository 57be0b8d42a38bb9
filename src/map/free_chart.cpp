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
  return std::ranges::all_of(open.mesh.triangles, [&](const Triangle& t) {
    const UV e = uv[t[1]] - uv[t[0]], f = uv[t[2]] - uv[t[0]], g = f - e;
    const double square = std::max({e.u * e.u + e.v * e.v, f.u * f.u + f.v * f.v, g.u * g.u + g.v * g.v});
    return e.u * f.v - e.v * f.u > least * square;
  });
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

// Descends from a valid map.
std::optional<ChartMap> relaxed(const OpenMesh& open, std::vector<UV> uv, const MapSummary& summary,
                                const Run& run) {
  if (!is_valid(open, uv)) return {};
  relax_conformally(open.points, open.mesh, open.loops, uv, run);
  if (!is_valid(open, uv)) return {};
  return laid_out(open, std::move(uv), summary);
}

// Maps inside the outline given by `uv`.
std::optional<ChartMap> anew_within(const OpenMesh& open, std::vector<UV> uv, double residual,
                                    const Run& run) {
  constexpr int repairs = 4;
  if (!crossing_points({open.loops.front()}, uv).empty()) return {};
  uv.resize(open.points.size() + open.loops.size() - 1);
  const Embedding inside = embed(open.points, open.mesh, open.loops, residual, repairs, uv, run);
  if (inside.flips > 0) return {};
  uv.resize(open.points.size());
  if (is_good(open, uv)) return laid_out(open, std::move(uv), inside.map);
  return relaxed(open, std::move(uv), inside.map, run);
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

std::optional<ChartMap> first_good(const OpenMesh& open, const std::vector<double>& turning, double residual,
                                   bool patient, const Run& run) {
  constexpr Index large = 30'000, too_large = 200'000;  // vertices: for least squares at first, and at all
  constexpr double little = 1e-3;                       // bound that leaves no inner edge without weight
  std::vector<UV> uv;
  if (open.vertices() > large && !turning.empty()) {
    const MapSummary summary = map_outline_first(open, turning, residual, uv, run);
    if (is_good(open, uv)) return laid_out(open, std::move(uv), summary);
    if (!patient || open.vertices() > too_large) return {};
  }
  for (const double least : {0.0, little}) {
    const MapSummary summary = free_map(open.points, open.mesh, open.loops.front().points, least, uv, run);
    if (is_good(open, uv)) return laid_out(open, std::move(uv), summary);
    if (have_height(open, uv)) break;
  }
  if (auto map = anew_within(open, uv, residual, run)) return map;
  if (!patient) return {};
  const auto disc = to_disc(open, residual, run);
  return disc ? relaxed(open, disc->uv, disc->summary, run) : std::nullopt;
}

// None where a system could not be solved.
template <class Map>
std::optional<ChartMap> where_solved(const Map& map) {
  try {
    return map();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::NoConvergence) throw;
    return {};
  }
}

}  // namespace

std::optional<ChartMap> disc_chart(const OpenMesh& open, double residual, const Run& run) {
  return where_solved([&] { return to_disc(open, residual, run); });
}

std::optional<ChartMap> free_chart(const OpenMesh& open, const std::vector<double>& turning, double residual,
                                   bool patient, const Run& run) {
  return where_solved([&] { return first_good(open, turning, residual, patient, run); });
}

}  // namespace rimline
