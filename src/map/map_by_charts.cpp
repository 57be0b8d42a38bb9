// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/map_by_charts.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "base/domain_traits.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "map/atlas.h"
#include "map/bisect.h"
#include "map/cut_graph.h"
#include "map/projected_charts.h"
#include "mesh/edges.h"
#include "solve/sparse.h"

namespace rimline {
namespace {

std::vector<OpenMesh> cut_along(const OpenMesh& open, const Cuts& cuts) {
  return open_parts(open, std::vector<Index>(open.mesh.triangles.size(), 0), cuts);
}

std::vector<OpenMesh> connected_parts(Points points, const std::vector<Triangle>& triangles) {
  const OpenMesh surface = open_surface(points, triangles);
  return open_parts(surface, std::vector<Index>(surface.mesh.triangles.size(), 0));
}

std::vector<OpenMesh> without_handles(OpenMesh part) {
  if (part.genus > 0) return cut_along(part, cut_handles(part));
  std::vector<OpenMesh> whole;
  whole.push_back(std::move(part));
  return whole;
}

// Makes discs with holes: closed surfaces are cut in two or by a slit.
std::vector<OpenMesh> discs_of(const OpenMesh& whole, bool in_two) {
  if (!whole.loops.empty()) return {whole};
  if (!in_two) {
    std::vector<OpenMesh> opened = cut_along(whole, slit(whole, 0, {}));
    if (!opened.front().loops.empty()) return opened;
  }
  return halves(whole, 0);
}

Atlas charts_within(const OpenMesh& whole, const ChartOptions& options, const AngleError& most_error,
                    std::int64_t triangles, const Run& run) {
  Atlas atlas(options, most_error, triangles, run);
  atlas.take(discs_of(whole, options.charts != 1));
  if (options.charts == 0 && atlas.charts().size() > 1) atlas.join(whole);
  return atlas;
}

// Lengths are kept at the cost of angles as far as these are not worse than in the disc's map.
Atlas charts_of(const OpenMesh& whole, const ChartOptions& options, std::int64_t triangles, const Run& run) {
  constexpr Index large = 200'000;  // vertices
  AngleError most_error;
  if (options.charts != 1 && !whole.loops.empty() && whole.vertices() <= large)
    most_error = error_of_disc(whole, options.residual, run);
  Atlas atlas = charts_within(whole, options, most_error, triangles, run);
  if (!(most_error.corner > 0) || atlas.failed() || !is_above(atlas.error(), most_error)) return atlas;
  return charts_within(whole, options, {}, triangles, run);
}

// From (0, 0) on.
void move_to_origin(std::vector<UV>& uv) {
  UV low = uv.front();
  for (const UV p : uv) low = {std::min(low.u, p.u), std::min(low.v, p.v)};
  for (UV& p : uv) p = p - low;
}

void append(Chart& chart, const std::vector<Triangle>& triangles, ChartedMap& map) {
  const auto first = static_cast<Index>(map.uv.size()), id = static_cast<Index>(map.charts++);
  move_to_origin(chart.map->uv);
  map.uv.insert(map.uv.end(), chart.map->uv.begin(), chart.map->uv.end());
  map.vertex.insert(map.vertex.end(), chart.open.vertex.begin(), chart.open.vertex.end());
  for (std::size_t i = 0; i < chart.open.triangle.size(); ++i) {
    const Index t = chart.open.triangle[i];
    const Triangle& own = chart.open.mesh.triangles[i];
    map.chart[t] = id;
    for (int c = 0; c < 3; ++c) {
      const Index v = chart.open.vertex[own[c]];
      const auto corner = std::ranges::find(triangles[t], v) - triangles[t].begin();
      map.corners[t][corner] = first + own[c];
      if (c == 0) map.turned[t] = triangles[t][(corner + 1) % 3] != chart.open.vertex[own[1]];
    }
    if (map.turned[t]) std::swap(map.corners[t][1], map.corners[t][2]);
  }
  if (!traits(chart.map->kind).released) map.kind = chart.map->kind;
  map.summary.unknowns += chart.map->summary.unknowns;
  map.summary.iterations += chart.map->summary.iterations;
  map.summary.residual = std::max(map.summary.residual, chart.map->summary.residual);
}

// Each edge of a seam is on two outlines, boundary edges on one.
double length_of_seams(const std::vector<Chart>& charts, double boundary) {
  double length = 0;
  for (const Chart& chart : charts) {
    for (const Loop& loop : chart.open.loops) length += loop.length;
  }
  return std::max(0.0, length - boundary) / 2;
}

double length_of_boundary(Points points, const std::vector<Triangle>& triangles) {
  double length = 0;
  for (const Edge& edge : edges_of(triangles)) {
    if (edge.triangles == 1) length += distance(points[edge.a], points[edge.b]);
  }
  return length;
}

}  // namespace

ChartedMap map_by_charts(Points points, const std::vector<Triangle>& triangles, const ChartOptions& options,
                         const Run& run) {
  Arena arena(run);
  return arena.execute([&] {
    const auto count = static_cast<std::int64_t>(triangles.size());
    Atlas atlas(options, {}, count, run);
    for (OpenMesh& part : connected_parts(points, triangles)) {
      if (options.charts != 1 && is_tangled(part)) {
        if (auto charts = projected_charts(part, run)) {
          std::ranges::move(*charts, std::back_inserter(atlas.charts()));
          continue;
        }
      }
      for (const OpenMesh& whole : without_handles(std::move(part)))
        atlas.append(charts_of(whole, options, count, run));
    }
    if (options.charts > 1) atlas.cut_to(static_cast<std::size_t>(options.charts));
    ChartedMap map;
    if (atlas.failed()) return map;
    map.kind = Domain::Free;
    map.corners.resize(triangles.size());
    map.chart.resize(triangles.size());
    map.turned.resize(triangles.size());
    for (Chart& chart : atlas.charts()) append(chart, triangles, map);
    if (map.uv.size() > points.size())
      map.seams = length_of_seams(atlas.charts(), length_of_boundary(points, triangles));
    return map;
  });
}

}  // namespace rimline
