// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "canvas.h"
#include "drawn_map.h"
#include "raster.h"
#include "rimline/arrange.h"
#include "rimline/io.h"
#include "rimline/neighbours.h"
#include "summary.h"
#include "view.h"

namespace rimline::cli {
namespace {

constexpr std::size_t most_edges = 40'000;  // more edges would only blacken the map

constexpr Colour near_point = {0.12, 0.27, 0.39};
constexpr Colour far_point = {0.80, 0.86, 0.90};
constexpr Colour grey_near = {0.58, 0.62, 0.66};
constexpr Colour grey_far = {0.88, 0.90, 0.92};
constexpr Colour candidate_colour = {0.91, 0.42, 0.05};
constexpr Colour outer_colour = {0.82, 0.10, 0.26};
constexpr Colour hole_colour = {0.06, 0.42, 0.80};
constexpr Colour front_colour = {0.93, 0.85, 0.72};
constexpr Colour back_colour = {0.56, 0.66, 0.78};

// Common data of the panels: the position of each point, and the distance of its neighbours.
struct Stage3d {
  const Scene& scene;
  View view;
  Fit fit;
  std::vector<Point> place;     // pixels of the panel; z toward the eye, in pixels; NaN where not finite
  std::vector<double> spacing;  // to the nearest six, in pixels; 0 where not used
  double near = 0, far = 0;     // the range of z
};

// The mean normal of the triangles, or the zero vector.
Point front_of(const Scene& scene) {
  Point sum;
  for (const auto& [a, b, c] : scene.triangles) {
    sum = sum + cross(scene.points[b] - scene.points[a], scene.points[c] - scene.points[a]);
  }
  return sum;
}

std::vector<double> spacing_in_pixels(Points points, double scale, const Run& run) {
  const Arrangement distinct = arrange(points, run);
  std::vector<double> result(points.size(), 0);
  if (distinct.points.size() < 2) return result;
  const auto spacing = local_spacing(distinct.points, find_neighbours(distinct.points, 6, run));
  for (std::size_t i = 0; i < spacing.size(); ++i) result[distinct.ids[i]] = scale * spacing[i];
  return result;
}

Stage3d arrange_stage(const Scene& scene, const Run& run) {
  Stage3d stage{.scene = scene, .view = {}, .fit = {}, .place = {}, .spacing = {}};
  stage.view = choose_view(scene.points, scene.boundary.loops, front_of(scene), scene.up);
  stage.place.reserve(scene.points.size());
  for (const Point p : scene.points) stage.place.push_back(stage.view.project(p));
  stage.fit = fit(stage.place);
  stage.near = -std::numeric_limits<double>::infinity();
  stage.far = -stage.near;
  for (Point& p : stage.place) {
    p = stage.fit.place(p);
    if (!is_finite(p)) continue;
    stage.near = std::max(stage.near, p.z);
    stage.far = std::min(stage.far, p.z);
  }
  stage.spacing = spacing_in_pixels(scene.points, stage.fit.scale, run);
  return stage;
}

// Opaque discs just behind the points, which hide the far side.
Raster solid(const Stage3d& stage, const Run& run) {
  Raster raster(fine * panel, fine * panel);
  for (std::size_t i = 0; i < stage.place.size(); ++i) {
    if (i % 65536 == 0) run.check_cancel();
    if (stage.spacing[i] == 0) continue;
    const Point behind = stage.place[i] - Point{0, 0, 5 * stage.spacing[i]};
    raster.screen(finer(behind), fine * std::min(stage.spacing[i], 40.0));
  }
  return raster;
}

double dot_radius(double spacing) { return std::clamp(0.36 * spacing, 0.55, 4.5); }

// All points, each in the colour that `colour(id, nearness)` gives; nearness runs from 0 to 1.
template <class ColourOf>
void draw_points(Raster& raster, const Stage3d& stage, const Run& run, const ColourOf& colour) {
  const double depth = std::max(stage.near - stage.far, 1e-9);
  for (std::size_t i = 0; i < stage.place.size(); ++i) {
    if (i % 65536 == 0) run.check_cancel();
    if (stage.spacing[i] == 0) continue;
    const double nearness = (stage.place[i].z - stage.far) / depth;
    raster.disc(finer(stage.place[i]), fine * dot_radius(stage.spacing[i]), colour(i, nearness));
  }
}

// The unit normal of a triangle in the axes of the view; zero where it has no area.
Point seen_normal(const Stage3d& stage, const Triangle& t) {
  const auto& p = stage.scene.points;
  const Point normal = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  const double length = norm(normal);
  return length > 0 ? stage.view.project((1 / length) * normal) : Point{};
}

constexpr Point light = {-0.37, 0.52, 0.77};  // beside the eye, above its left shoulder
constexpr Colour shadow = {0.16, 0.16, 0.20};

// Lambert's cosine law; the two sides of the surface differ in colour.
Colour shade(const Stage3d& stage, const Triangle& t) {
  const Point n = seen_normal(stage, t);
  const double facing = n.z >= 0 ? dot(n, light) : -dot(n, light);
  return mix(shadow, n.z >= 0 ? front_colour : back_colour, 0.30 + 0.75 * std::max(0.0, facing));
}

// The same light for the map, where the whole surface is visible: it fades towards the far side.
Colour shade_all_round(const Stage3d& stage, const Triangle& t) {
  return mix(shadow, front_colour, 0.25 + 0.40 * (1 + dot(seen_normal(stage, t), light)));
}

void draw_mesh(Raster& raster, const Stage3d& stage, const Run& run) {
  std::size_t count = 0;
  for (const Triangle& t : stage.scene.triangles) {
    if (count++ % 65536 == 0) run.check_cancel();
    raster.triangle(finer(stage.place[t[0]]), finer(stage.place[t[1]]), finer(stage.place[t[2]]),
                    shade(stage, t));
  }
}

Colour colour_of(LoopKind kind) { return kind == LoopKind::Outer ? outer_colour : hole_colour; }

// Draws the loops: strong where they are visible, thin where they are hidden.
void draw_loops(cairo_t* cairo, const Stage3d& stage, const Raster& hiding) {
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  for (const bool visible : {false, true}) {
    for (const Loop& loop : stage.scene.boundary.loops) {
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Index from = loop.points[i], to = loop.points[(i + 1) % loop.points.size()];
        const Point a = stage.place[from], b = stage.place[to];
        const double tolerance = 3 * std::max({stage.spacing[from], stage.spacing[to], 1.0});
        if (hiding.sees(finer(0.5 * (a + b)), fine * tolerance) != visible) continue;
        cairo_move_to(cairo, a.x, a.y);
        cairo_line_to(cairo, b.x, b.y);
      }
      set_colour(cairo, colour_of(loop.kind), visible ? 1 : 0.35);
      cairo_set_line_width(cairo, visible ? 3.2 : 1.4);
      cairo_stroke(cairo);
    }
  }
}

// The edges of the mesh as thin lines, each once, where `seen` says so.
template <class Seen>
void draw_edges(cairo_t* cairo, std::span<const Triangle> triangles, const std::vector<Point>& at,
                const Seen& seen) {
  if (triangles.size() * 3 / 2 > most_edges) return;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Index from = t[i], to = t[(i + 1) % 3];
      if (from > to || !seen(from, to)) continue;  // those on the boundary are drawn as loops
      cairo_move_to(cairo, at[from].x, at[from].y);
      cairo_line_to(cairo, at[to].x, at[to].y);
    }
  }
  set_colour(cairo, ink, 0.35);
  cairo_set_line_width(cairo, 0.35);
  cairo_stroke(cairo);
}

void panel_points(cairo_t* cairo, const Stage3d& stage, const Raster& screen, const Run& run) {
  Raster raster = screen;
  draw_points(raster, stage, run,
              [](std::size_t, double nearness) { return mix(far_point, near_point, nearness); });
  paint(cairo, raster);
}

// Points that `flags` marks in the colour, the others in grey.
void panel_marked(cairo_t* cairo, const Stage3d& stage, const Raster& screen,
                  const std::vector<std::uint8_t>& flags, Colour colour, const Run& run) {
  Raster raster = screen;
  draw_points(raster, stage, run, [&](std::size_t i, double nearness) {
    if (flags[i] != 0) return mix(mix(colour, grey_far, 0.35), colour, nearness);
    return mix(grey_far, grey_near, nearness);
  });
  paint(cairo, raster);
}

void panel_probability(cairo_t* cairo, const Stage3d& stage, const Raster& screen, const Run& run) {
  Raster raster = screen;
  const auto& probability = stage.scene.boundary.boundary_probability;
  draw_points(raster, stage, run, [&](std::size_t i, double nearness) {
    return mix(mix(grey_far, grey_near, nearness), candidate_colour, probability[i]);
  });
  paint(cairo, raster);
}

void panel_boundary(cairo_t* cairo, const Stage3d& stage, const Raster& screen, const Run& run) {
  Raster raster = screen;
  draw_points(raster, stage, run,
              [](std::size_t, double nearness) { return mix(grey_far, grey_near, nearness); });
  paint(cairo, raster);
  draw_loops(cairo, stage, screen);
}

// Edges as lines, such as outlines of charts.
void draw_sides(cairo_t* cairo, const std::vector<std::pair<Index, Index>>& sides,
                const std::vector<Point>& at, Colour colour, double width) {
  for (const auto& [from, to] : sides) {
    cairo_move_to(cairo, at[from].x, at[from].y);
    cairo_line_to(cairo, at[to].x, at[to].y);
  }
  set_colour(cairo, colour);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(cairo, width);
  cairo_stroke(cairo);
}

std::vector<Point> places_in_uv(std::span<const UV> uv) {
  std::vector<Point> places;
  places.reserve(uv.size());
  for (const UV p : uv) places.push_back({p.u, p.v, std::isfinite(p.u + p.v) ? 0 : std::nan("")});
  const Fit plane = fit(places);
  for (Point& p : places) p = plane.place(p);
  return places;
}

void draw_uv_loops(cairo_t* cairo, const std::vector<Loop>& loops, const std::vector<Point>& at) {
  cairo_set_line_width(cairo, 3.2);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  for (const Loop& loop : loops) {
    bool placed = true;
    for (const Index id : loop.points) placed = placed && is_finite(at[id]);
    if (!placed) continue;  // a hole that the map fills has no outline of its own
    cairo_new_path(cairo);
    for (const Index id : loop.points) cairo_line_to(cairo, at[id].x, at[id].y);
    cairo_close_path(cairo);
    set_colour(cairo, colour_of(loop.kind));
    cairo_stroke(cairo);
  }
}

// Draws the surface in the plane of the map, each triangle with its shading in space.
void panel_map(cairo_t* cairo, const Stage3d& stage, const Run& run) {
  const Scene& scene = stage.scene;
  const DrawnMap map = drawn_map(scene);
  const auto at = places_in_uv(map.uv);
  Raster raster(fine * panel, fine * panel);
  run.check_cancel();
  for (std::size_t i = 0; i < map.corners.size(); ++i) {
    const Triangle& t = map.corners[i];
    raster.triangle(finer(at[t[0]]), finer(at[t[1]]), finer(at[t[2]]),
                    shade_all_round(stage, map.triangles[i]));
  }
  if (scene.triangles.empty()) {
    for (const Point p : at) {
      if (is_finite(p)) raster.disc(finer(p), fine * 0.8, near_point);
    }
  }
  paint(cairo, raster);
  draw_edges(cairo, map.corners, at, [](Index, Index) { return true; });
  if (scene.seams.empty() && map.left_out == 0) return draw_uv_loops(cairo, scene.boundary.loops, at);
  const Outline outline = outline_of(map);
  draw_sides(cairo, outline.seams, at, ink, 1.2);
  draw_sides(cairo, outline.boundary, at, outer_colour, 2.4);
}

void panel_mesh(cairo_t* cairo, const Stage3d& stage, const Run& run) {
  Raster raster(fine * panel, fine * panel);
  draw_mesh(raster, stage, run);
  paint(cairo, raster);
  draw_edges(cairo, stage.scene.triangles, stage.place, [&](Index from, Index to) {
    return raster.sees(finer(0.5 * (stage.place[from] + stage.place[to])), fine * 0.5 * stage.spacing[from]);
  });
  draw_loops(cairo, stage, raster);
}

struct Panel {
  std::string title, note;
  std::function<void(cairo_t*)> draw;
};

std::string plural(std::size_t count, const std::string& noun) {
  return with_commas(static_cast<long long>(count)) + " " + noun + (count == 1 ? "" : "s");
}

std::vector<Panel> panels_of(const Stage3d& stage, const Raster& screen, const Run& run) {
  const Scene& scene = stage.scene;
  const Report& report = scene.boundary.report;
  std::vector<Panel> panels = {{"points", plural(report.points.used, "point"),
                                [&](cairo_t* cairo) { panel_points(cairo, stage, screen, run); }}};
  const auto& probability = scene.boundary.boundary_probability;
  if (probability.empty()) {
    panels.push_back({"candidates", plural(report.candidates, "candidate"), [&](cairo_t* cairo) {
                        panel_marked(cairo, stage, screen, scene.boundary.candidate, candidate_colour, run);
                      }});
  } else {
    const auto likely =
        std::count_if(probability.begin(), probability.end(), [](float p) { return p > 0.5F; });
    panels.push_back({"probability", plural(likely, "point") + " above 0.5",
                      [&](cairo_t* cairo) { panel_probability(cairo, stage, screen, run); }});
  }
  if (!scene.boundary.chromosome.empty()) {
    panels.push_back({"chromosome", plural(report.search.winner_points, "point"), [&](cairo_t* cairo) {
                        panel_marked(cairo, stage, screen, scene.boundary.chromosome, outer_colour, run);
                      }});
  }
  std::size_t on_loops = 0;
  for (const Loop& loop : scene.boundary.loops) on_loops += loop.points.size();
  panels.push_back({"boundary",
                    plural(scene.boundary.loops.size(), "loop") + ", " + plural(on_loops, "point"),
                    [&](cairo_t* cairo) { panel_boundary(cairo, stage, screen, run); }});
  if (!scene.uv.empty()) {
    const bool mapped = std::ranges::any_of(scene.uv, [](UV p) { return std::isfinite(p.u); });
    const bool drawn = mapped || !scene.seams.empty();
    const std::string charts = tell_charts(drawn_map(scene));
    const std::string residual = fmt::format("residual {:.0e}", report.map.residual);
    panels.push_back({"map",
                      !drawn           ? "none"
                      : charts.empty() ? residual
                                       : charts,
                      [&](cairo_t* cairo) { panel_map(cairo, stage, run); }});
  }
  if (!scene.triangles.empty()) {
    panels.push_back({"mesh", plural(scene.triangles.size(), "triangle"),
                      [&](cairo_t* cairo) { panel_mesh(cairo, stage, run); }});
  }
  return panels;
}

// The requested panels, in that order; all where none was requested. Throws BadOption for an unknown one.
std::vector<Panel> chosen(const std::vector<Panel>& panels, const std::vector<std::string>& names) {
  if (names.empty()) return panels;
  std::vector<Panel> result;
  for (const std::string& wanted : names) {
    const auto panel = std::ranges::find(panels, wanted, &Panel::title);
    if (panel == panels.end()) {
      throw Error(ErrorCode::BadOption, fmt::format("--panels: this run has no panel '{}'", wanted));
    }
    result.push_back(*panel);
  }
  return result;
}

void draw_all(cairo_t* cairo, const std::vector<Panel>& panels, const Run& run) {
  cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_paint(cairo);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    run.progress(Stage::Write, i, panels.size());
    cairo_save(cairo);
    cairo_translate(cairo, gap + static_cast<double>(i) * (panel + gap), 0);
    write_title(cairo, panels[i].title, panels[i].note);
    cairo_translate(cairo, 0, head);
    panels[i].draw(cairo);
    cairo_restore(cairo);
  }
}

}  // namespace

void write_picture(const std::string& path, const Scene& scene, const Run& run) {
  const Stage3d stage = arrange_stage(scene, run);
  const Raster screen = solid(stage, run);
  const auto panels = chosen(panels_of(stage, screen, run), scene.panels);
  const int width = gap + static_cast<int>(panels.size()) * (panel + gap), height = head + panel + gap;
  write_drawing(path, width, height, static_cast<double>(scene.panel_size) / panel,
                [&](cairo_t* cairo) { draw_all(cairo, panels, run); });
}

}  // namespace rimline::cli
