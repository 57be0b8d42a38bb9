// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/sound.h"

#include <algorithm>
#include <cmath>

#include "quality/mesh_score.h"
#include "quality/nearest.h"

namespace rimline::bench {
namespace {

// Corners, and places at most `step` apart along the edges and inside.
void add_places(Point a, Point b, Point c, double step, std::vector<Point>& places) {
  constexpr int most = 100;  // steps along an edge: a mesh with such edges is lost anyway
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const int steps = std::clamp(static_cast<int>(std::ceil(longest / step)), 1, most);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double s = static_cast<double>(i) / steps, t = static_cast<double>(j) / steps;
      places.push_back((1 - s - t) * a + s * b + t * c);
    }
  }
}

std::vector<Point> places_on(const Case& c, const std::vector<Triangle>& mesh) {
  std::vector<Point> places;
  for (const Triangle& t : mesh) {
    const double spacing = std::min({c.spacing[t[0]], c.spacing[t[1]], c.spacing[t[2]]});
    add_places(c.points[t[0]], c.points[t[1]], c.points[t[2]], spacing / 2, places);
  }
  return places;
}

// The largest distance from a place of `from` to the points of `to`, in spacings of the input there.
double farthest(const Case& c, const NearestPoint& input, const std::vector<Point>& from,
                const NearestPoint& to) {
  double most = 0;
  for (const Point& p : from) most = std::max(most, to.to(p).distance / c.spacing[input.to(p).id]);
  return most;
}

bool has_topology(const TrueSurface& surface, const Metrics& m) {
  return m.at("euler") == static_cast<double>(surface.euler) && m.at("components") == 1 &&
         m.at("boundary_loops") == static_cast<double>(surface.loops);
}

}  // namespace

Metrics score_soundness(const Case& c, const std::vector<Triangle>& mesh, const Metrics& m) {
  if (mesh.empty()) return {{"sound", 0}};
  constexpr double farthest_sound = 2, clean_area = 0.05, noisy_area = 0.15, least_f1 = 0.8;
  Metrics s;
  const NearestPoint input(c.points);
  const std::vector<Point> places = places_on(c, mesh);
  s["farthest_from_surface"] = farthest(c, input, places, NearestPoint(c.surface->points));
  s["farthest_from_mesh"] = farthest(c, input, c.surface->points, NearestPoint(places));
  s["area_over_truth"] = area_of(c.points, mesh) / c.surface->area;
  const double area_tolerance = c.name.noise > 0 ? noisy_area : clean_area;

  s["sound_topology"] = has_topology(*c.surface, m);
  s["sound_manifold"] = m.at("nonmanifold_edges") == 0 && m.at("nonmanifold_vertices") == 0;
  s["sound_distance"] =
      s["farthest_from_surface"] < farthest_sound && s["farthest_from_mesh"] < farthest_sound;
  s["sound_area"] = std::abs(s["area_over_truth"] - 1) <= area_tolerance;
  s["sound_boundary"] = m.at("boundary_points_f1") >= least_f1;
  s["sound"] =
      s["sound_topology"] * s["sound_manifold"] * s["sound_distance"] * s["sound_area"] * s["sound_boundary"];
  return s;
}

}  // namespace rimline::bench
