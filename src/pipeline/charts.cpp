// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/domain_traits.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "patch/pack.h"
#include "pipeline/component_parts.h"
#include "rimline/map_by_charts.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A component and its map.
struct Part : ComponentPart {
  std::vector<Point> points;
  ChartedMap map;
  double area = 0;
};

std::vector<Part> parts_of(const MappedMesh& mesh) {
  std::vector<Part> parts;
  for (ComponentPart& own : component_parts(mesh)) {
    Part& part = parts.emplace_back(Part{std::move(own), {}, {}, 0});
    for (const Index v : part.vertices) part.points.push_back(mesh.vertices[v]);
    for (const Index t : part.places) part.area += triangle_area(mesh.vertices, mesh.triangles[t]);
  }
  return parts;
}

// The domain's map: one position a vertex.
void keep_map(const MappedMesh& mesh, std::size_t component, Part& part) {
  ChartedMap& map = part.map;
  map.kind = mesh.components[component].map;
  map.charts = 1;
  for (Index v = 0; v < static_cast<Index>(part.vertices.size()); ++v) {
    map.uv.push_back(mesh.uv[part.vertices[v]]);
    map.vertex.push_back(v);
  }
  map.corners = part.triangles;
  map.chart.assign(part.triangles.size(), 0);
  map.turned.assign(part.triangles.size(), 0);
}

// Small components use one thread each, large ones all threads.
void map_parts(std::vector<Part>& parts, const std::vector<std::size_t>& wanted, const ChartOptions& options,
               const Run& run) {
  constexpr std::size_t large = 20'000;  // points
  std::vector<std::size_t> small;
  for (const std::size_t p : wanted) {
    if (wanted.size() > 1 && parts[p].points.size() < large) {
      small.push_back(p);
    } else {
      parts[p].map = map_by_charts(parts[p].points, parts[p].triangles, options, run);
    }
  }
  Run alone = run.without_progress();
  alone.threads = 1;
  parallel_tasks(small.size(), Stage::Refine, run, [&](std::size_t i) {
    Part& part = parts[small[i]];
    part.map = map_by_charts(part.points, part.triangles, options, alone);
  });
}

double area_in_map(const ChartedMap& map) {
  double area = 0;
  for (const Triangle& t : map.corners) area += 0.5 * twice_area(map.uv, t);
  return area;
}

// Scales a map: charts have the scale of the surface, maps to a domain that of the domain.
void set_scale(const ParameterizeOptions& options, bool charted, Part& part) {
  const bool real = options.uv_scale != UvScale::Domain || traits(options.domain).released;
  if (real == charted || part.map.charts == 0) return;
  const double wanted = real ? part.area : std::numbers::pi;  // the unit disc's
  const double scale = std::sqrt(wanted / std::max(area_in_map(part.map), 1e-300));
  for (UV& p : part.map.uv) p = {scale * p.u, scale * p.v};
}

// The positions of all parts.
struct Layout {
  std::vector<UV> uv;
  std::vector<Index> vertex, chart;  // of each place
};

Layout lay_out(MappedMesh& mesh, const std::vector<Part>& parts, std::vector<Triangle>& corners) {
  Layout layout;
  Index charts = 0;
  corners.assign(mesh.triangles.size(), {none, none, none});
  mesh.chart.assign(mesh.triangles.size(), none);
  for (const Part& part : parts) {
    const ChartedMap& map = part.map;
    if (map.charts == 0) continue;
    const auto first = static_cast<Index>(layout.uv.size());
    layout.uv.insert(layout.uv.end(), map.uv.begin(), map.uv.end());
    layout.chart.resize(layout.uv.size(), none);
    for (const Index v : map.vertex) layout.vertex.push_back(part.vertices[v]);
    for (std::size_t i = 0; i < part.places.size(); ++i) {
      const Index t = part.places[i];
      mesh.chart[t] = charts + map.chart[i];
      for (int c = 0; c < 3; ++c) {
        corners[t][c] = first + map.corners[i][c];
        layout.chart[corners[t][c]] = mesh.chart[t];
      }
    }
    charts += static_cast<Index>(map.charts);
  }
  return layout;
}

// Fits all charts in the square from 0 to 1.
void fit_unit_square(std::vector<UV>& uv) {
  if (uv.empty()) return;
  UV low = uv.front(), high = low;
  for (const UV p : uv) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  constexpr double margin = 1.0 / 256;  // at each side
  const double extent = std::max({high.u - low.u, high.v - low.v, 1e-300});
  const double scale = (1 - 2 * margin) / extent;
  for (UV& p : uv) p = {margin + scale * (p.u - low.u), margin + scale * (p.v - low.v)};
}

// Whether a triangle lost its area by rounding at the position of its chart.
bool is_turned(const Part& part, const std::vector<Triangle>& corners, const std::vector<UV>& uv) {
  return part.map.charts > 0 &&
         std::ranges::any_of(part.places, [&](Index t) { return !(twice_area(uv, corners[t]) > 0); });
}

// Removes the maps of parts with triangles without area.
Layout lay_out_sound(MappedMesh& mesh, std::vector<Part>& parts, UvScale scale,
                     std::vector<Triangle>& corners) {
  constexpr double gap = 1.0 / 64;  // between small charts: 4 pixels and more of a texture of 512
  for (;;) {
    Layout layout = lay_out(mesh, parts, corners);
    std::size_t charts = 0, dropped = 0;
    for (const Part& part : parts) charts += part.map.charts;
    pack_patches(layout.chart, charts, layout.uv, gap);
    if (scale == UvScale::Unit) fit_unit_square(layout.uv);
    for (Part& part : parts) {
      if (!is_turned(part, corners, layout.uv)) continue;
      part.map = {};
      ++dropped;
    }
    if (dropped == 0) return layout;
  }
}

// Turns triangles of one-sided surfaces as their charts face.
void turn_triangles(const std::vector<Part>& parts, MappedMesh& mesh) {
  for (const Part& part : parts) {
    for (std::size_t i = 0; i < part.map.turned.size(); ++i) {
      Triangle& t = mesh.triangles[part.places[i]];
      if (part.map.turned[i]) std::swap(t[1], t[2]);
    }
  }
}

// A vertex of one position has it; a vertex of several has none of its own.
void give_places(const Layout& layout, std::vector<Triangle> corners, MappedMesh& mesh) {
  std::vector<Index> count(mesh.vertices.size(), 0);
  for (const Index v : layout.vertex) ++count[v];
  mesh.uv.assign(mesh.vertices.size(), {nan, nan});
  std::vector<Index> place(layout.uv.size());
  for (std::size_t i = 0; i < layout.uv.size(); ++i) {
    const Index v = layout.vertex[i];
    if (count[v] == 1) {
      mesh.uv[v] = layout.uv[i];
      place[i] = v;
      continue;
    }
    place[i] = static_cast<Index>(mesh.vertices.size() + mesh.seams.uv.size());
    mesh.seams.uv.push_back(layout.uv[i]);
    mesh.seams.point.push_back(v);
  }
  if (mesh.seams.empty()) return;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (int c = 0; c < 3; ++c)
      corners[t][c] = corners[t][c] == none ? mesh.triangles[t][c] : place[corners[t][c]];
  }
  mesh.seams.corners = std::move(corners);
}

void report_on(const std::vector<Part>& parts, const std::vector<std::size_t>& charted, MappedMesh& mesh) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    mesh.components[p].map = parts[p].map.kind;
    mesh.components[p].charts = parts[p].map.charts;
    mesh.components[p].seams = parts[p].map.seams;
  }
  for (const std::size_t p : charted) {
    const MapSummary& own = parts[p].map.summary;
    mesh.map.unknowns += own.unknowns;
    mesh.map.iterations += own.iterations;
    mesh.map.residual = std::max(mesh.map.residual, own.residual);
  }
}

// The maps unchanged, one position a vertex.
MappedMesh with_chart_a_component(MappedMesh mesh) {
  std::vector<Index> chart_of(mesh.components.size(), none);
  Index charts = 0;
  for (std::size_t c = 0; c < mesh.components.size(); ++c) {
    if (!has_map(mesh.components[c].map) || mesh.components[c].triangles == 0) continue;
    chart_of[c] = charts++;
    mesh.components[c].charts = 1;
  }
  mesh.chart.clear();
  mesh.chart.reserve(mesh.triangles.size());
  for (const Index component : mesh.triangle_patch) mesh.chart.push_back(chart_of[component]);
  return mesh;
}

}  // namespace

MappedMesh map_charts(MappedMesh mesh, const ParameterizeOptions& options, const Run& run) {
  if (!has_map(options.domain)) return with_chart_a_component(std::move(mesh));
  const bool all_mapped =
      std::ranges::none_of(mesh.components, [](const auto& c) { return c.triangles > 0 && !has_map(c.map); });
  if (all_mapped && options.uv_scale == UvScale::Domain) return with_chart_a_component(std::move(mesh));
  std::vector<Part> parts = parts_of(mesh);
  std::vector<std::size_t> charted;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].triangles.empty()) continue;
    if (!has_map(mesh.components[p].map)) {
      charted.push_back(p);
    } else {
      keep_map(mesh, p, parts[p]);
    }
  }
  map_parts(parts, charted, {.charts = options.charts, .residual = options.residual}, run);
  for (std::size_t p = 0; p < parts.size(); ++p)
    set_scale(options, std::ranges::binary_search(charted, p), parts[p]);
  std::vector<Triangle> corners;
  const Layout layout = lay_out_sound(mesh, parts, options.uv_scale, corners);
  turn_triangles(parts, mesh);
  give_places(layout, std::move(corners), mesh);
  report_on(parts, charted, mesh);
  return mesh;
}

}  // namespace rimline::pipeline
