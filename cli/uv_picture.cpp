// SPDX-License-Identifier: GPL-3.0-or-later
#include "uv_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "canvas.h"
#include "drawn_map.h"
#include "view.h"

namespace rimline::cli {
namespace {

constexpr int squares = 32;                 // along the longer side of the layout
constexpr std::size_t most_edges = 40'000;  // more of them would only blacken the layout
constexpr Colour light_square = {0.96, 0.95, 0.91};
constexpr Colour dark_square = {0.35, 0.50, 0.66};
constexpr Colour outline = {0.82, 0.10, 0.26};
constexpr Colour shadow = {0.16, 0.16, 0.20};

// The checkerboard in the plane of the map.
struct Board {
  double side = 1;

  Colour at(double u, double v) const {
    const auto number =
        static_cast<long long>(std::floor(u / side)) + static_cast<long long>(std::floor(v / side));
    return number % 2 == 0 ? light_square : dark_square;
  }
};

Board board_of(const DrawnMap& map) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double left = infinite, right = -infinite, bottom = infinite, top = -infinite;
  for (const UV p : map.uv) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v)) continue;
    left = std::min(left, p.u), right = std::max(right, p.u);
    bottom = std::min(bottom, p.v), top = std::max(top, p.v);
  }
  const double extent = std::max(right - left, top - bottom);
  return {extent > 0 && std::isfinite(extent) ? extent / squares : 1};
}

// Where each vertex is on its panel.
using Places = std::vector<Point>;

Places placed(std::vector<Point> projected) {
  const Fit plane = fit(projected);
  for (Point& p : projected) p = plane.place(p);
  return projected;
}

Places places_in_plane(const DrawnMap& map) {
  std::vector<Point> places;
  places.reserve(map.uv.size());
  for (const UV p : map.uv) places.push_back({p.u, p.v, 0});
  return placed(std::move(places));
}

View view_of(const Scene& scene) {
  Point front;
  for (const auto& [a, b, c] : scene.triangles)
    front = front + cross(scene.points[b] - scene.points[a], scene.points[c] - scene.points[a]);
  return choose_view(scene.points, scene.boundary.loops, front, scene.up);
}

Places places_in_space(const Scene& scene, const View& view) {
  std::vector<Point> places;
  places.reserve(scene.points.size());
  for (const Point p : scene.points) places.push_back(view.project(p));
  return placed(std::move(places));
}

// All triangles with their squares, each where `at` puts its corners; `bright(t)` from 0 to 1 is its light.
template <class Bright>
void draw_squares(cairo_t* cairo, const DrawnMap& map, const Board& board, const std::vector<Triangle>& at,
                  const Places& places, const Run& run, const Bright& bright) {
  Raster raster(fine * panel, fine * panel);
  for (std::size_t i = 0; i < map.corners.size(); ++i) {
    if (i % 65536 == 0) run.check_cancel();
    const UV a = map.uv[map.corners[i][0]], b = map.uv[map.corners[i][1]], c = map.uv[map.corners[i][2]];
    const double light = bright(map.triangles[i]);
    raster.triangle(finer(places[at[i][0]]), finer(places[at[i][1]]), finer(places[at[i][2]]),
                    [&](double wb, double wc) {
                      const double u = a.u + wb * (b.u - a.u) + wc * (c.u - a.u);
                      const double v = a.v + wb * (b.v - a.v) + wc * (c.v - a.v);
                      return mix(shadow, board.at(u, v), light);
                    });
  }
  paint(cairo, raster);
}

void draw_edges(cairo_t* cairo, const DrawnMap& map, const Places& places) {
  if (map.corners.size() * 3 / 2 > most_edges) return;
  for (const Triangle& t : map.corners) {
    for (int c = 0; c < 3; ++c) {
      const Index from = t[c], to = t[(c + 1) % 3];
      if (from > to) continue;  // those on the boundary are drawn as loops
      cairo_move_to(cairo, places[from].x, places[from].y);
      cairo_line_to(cairo, places[to].x, places[to].y);
    }
  }
  set_colour(cairo, ink, 0.5);
  cairo_set_line_width(cairo, 0.35);
  cairo_stroke(cairo);
}

// Of charts: boundary and seams.
void draw_chart_outlines(cairo_t* cairo, const DrawnMap& map, const Places& places) {
  const Outline outlines = outline_of(map);
  for (const bool seam : {true, false}) {
    for (const auto& [from, to] : seam ? outlines.seams : outlines.boundary) {
      cairo_move_to(cairo, places[from].x, places[from].y);
      cairo_line_to(cairo, places[to].x, places[to].y);
    }
    set_colour(cairo, seam ? ink : outline);
    cairo_set_line_width(cairo, seam ? 1.2 : 2.4);
    cairo_stroke(cairo);
  }
}

void draw_outlines(cairo_t* cairo, const Scene& scene, const DrawnMap& map, const Places& places) {
  if (!scene.seams.empty() || map.left_out > 0) return draw_chart_outlines(cairo, map, places);
  cairo_set_line_width(cairo, 2.4);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  for (const Loop& loop : scene.boundary.loops) {
    const bool all =
        std::all_of(loop.points.begin(), loop.points.end(), [&](Index id) { return is_finite(places[id]); });
    if (!all) continue;
    cairo_new_path(cairo);
    for (const Index id : loop.points) cairo_line_to(cairo, places[id].x, places[id].y);
    cairo_close_path(cairo);
    set_colour(cairo, outline);
    cairo_stroke(cairo);
  }
}

}  // namespace

void write_uv_picture(const std::string& path, const Scene& scene, const Run& run) {
  const DrawnMap map = drawn_map(scene);
  const Board board = board_of(map);
  const View view = view_of(scene);
  const auto lambert = [&](const Triangle& t) {
    constexpr Point light = {-0.37, 0.52, 0.77};  // beside the eye, above its left shoulder
    const Point n = cross(scene.points[t[1]] - scene.points[t[0]], scene.points[t[2]] - scene.points[t[0]]);
    const double size = norm(n);
    return size > 0 ? 0.4 + 0.6 * std::abs(dot(view.project((1 / size) * n), light)) : 0.4;
  };
  const DistortionSummary& distortion = scene.boundary.report.distortion;
  const std::string charts = tell_charts(map);
  const auto draw = [&](cairo_t* cairo) {
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_translate(cairo, gap, 0);
    write_title(cairo, fmt::format("map, {}", name(scene.boundary.report.options.map.domain)),
                charts.empty() ? fmt::format("{} triangles", map.triangles.size()) : charts);
    cairo_translate(cairo, 0, head);
    const Places flat = places_in_plane(map);
    draw_squares(cairo, map, board, map.corners, flat, run, [](const Triangle&) { return 1.0; });
    draw_edges(cairo, map, flat);
    draw_outlines(cairo, scene, map, flat);
    cairo_translate(cairo, panel + gap, -head);
    write_title(cairo, "on the surface",
                fmt::format("angles off by {:.3f} rad on average", distortion.angle_mean));
    cairo_translate(cairo, 0, head);
    draw_squares(cairo, map, board, map.triangles, places_in_space(scene, view), run, lambert);
  };
  write_drawing(path, gap + 2 * (panel + gap), head + panel + gap,
                static_cast<double>(scene.panel_size) / panel, draw);
}

}  // namespace rimline::cli
