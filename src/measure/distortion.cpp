// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/corner_angles.h"
#include "parallel.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

// One triangle before its component's scale is known.
struct TriangleMap {
  double area = 0, uv_area = 0;  // uv_area without its sign
  double angle = 0;              // mean difference over the corners
  double square = 0, most = 0;   // of the singular values from uv to space: mean square, larger one squared
};

// The map from uv to space is linear on the triangle; a, b, c are its metric in uv (Sander et al. 2001).
TriangleMap map_of(const std::array<Point, 3>& p, const std::array<UV, 3>& q) {
  TriangleMap map;
  const Point e = p[1] - p[0], f = p[2] - p[0];
  const UV s{q[1].u - q[0].u, q[1].v - q[0].v}, t{q[2].u - q[0].u, q[2].v - q[0].v};
  const double twice = s.u * t.v - s.v * t.u;
  map.area = 0.5 * norm(cross(e, f));
  map.uv_area = 0.5 * std::abs(twice);
  const auto flat = corner_angles({q[0].u, q[0].v, 0}, {q[1].u, q[1].v, 0}, {q[2].u, q[2].v, 0});
  const auto solid = corner_angles(p[0], p[1], p[2]);
  for (int i = 0; i < 3; ++i) map.angle += std::abs(flat[i] - solid[i]) / 3;
  const Point du = (1 / twice) * (t.v * e - s.v * f), dv = (1 / twice) * (s.u * f - t.u * e);
  const double a = dot(du, du), b = dot(du, dv), c = dot(dv, dv);
  map.square = (a + c) / 2;
  map.most = (a + c + std::sqrt((a - c) * (a - c) + 4 * b * b)) / 2;
  if (twice == 0 || !std::isfinite(map.most)) map.square = map.most = std::numeric_limits<double>::infinity();
  return map;
}

// Sums over the triangles of a component, or of all.
struct Sums {
  double area = 0, uv_area = 0;
  double angle = 0, log_ratio = 0, square = 0;
  double angle_most = 0, ratio_least = std::numeric_limits<double>::infinity(), ratio_most = 0, stretch = 0;
  bool any = false;

  DistortionSummary summary() const {
    if (!any || area == 0) return {};
    return {angle / area, angle_most, ratio_least, ratio_most, log_ratio / area, std::sqrt(square / area),
            stretch};
  }
};

void add(const TriangleMap& map, double scale, Sums& sums) {
  sums.any = true;
  sums.angle += map.angle * map.area;
  sums.angle_most = std::max(sums.angle_most, map.angle);
  if (map.area == 0) return;  // has no ratio
  const double ratio = map.uv_area / map.area * scale * scale;
  sums.ratio_least = std::min(sums.ratio_least, ratio);
  sums.ratio_most = std::max(sums.ratio_most, ratio);
  sums.log_ratio += std::abs(std::log(ratio)) * map.area;
  sums.square += map.square / (scale * scale) * map.area;
  sums.stretch = std::max(sums.stretch, std::sqrt(map.most) / scale);
}

void resize(Distortion::Values& values, std::size_t count, float value) {
  for (auto* list : {&values.angle, &values.area, &values.stretch, &values.max_stretch})
    list->assign(count, value);
}

// The mean over the triangles of each point.
void spread_to_points(const std::vector<Triangle>& triangles, const std::vector<TriangleMap>& maps,
                      std::size_t points, Distortion& distortion) {
  std::vector<double> weight(points, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index v : triangles[t]) weight[v] += maps[t].area;
  }
  const auto mean = [&](const std::vector<float>& of_triangle, std::vector<float>& of_point) {
    std::vector<double> sum(points, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (maps[t].area == 0) continue;
      for (const Index v : triangles[t]) sum[v] += maps[t].area * of_triangle[t];
    }
    of_point.resize(points);
    for (std::size_t v = 0; v < points; ++v) of_point[v] = static_cast<float>(sum[v] / weight[v]);
  };
  mean(distortion.triangle.angle, distortion.point.angle);
  mean(distortion.triangle.area, distortion.point.area);
  mean(distortion.triangle.stretch, distortion.point.stretch);
  mean(distortion.triangle.max_stretch, distortion.point.max_stretch);
}

}  // namespace

Distortion measure_distortion(Points points, const std::vector<Triangle>& triangles, std::span<const UV> uv,
                              std::span<const Index> component, std::size_t component_count, const Run& run) {
  std::vector<TriangleMap> maps(triangles.size());
  parallel_for_each(triangles.size(), Stage::Measure, run, [&](Index t) {
    const auto& [a, b, c] = triangles[t];
    maps[t] = map_of({points[a], points[b], points[c]}, {uv[a], uv[b], uv[c]});
  });
  const auto component_of = [&](std::size_t t) { return component.empty() ? 0 : component[t]; };
  std::vector<Sums> parts(std::max<std::size_t>(component_count, 1));
  for (std::size_t t = 0; t < maps.size(); ++t) {
    parts[component_of(t)].area += maps[t].area;
    parts[component_of(t)].uv_area += maps[t].uv_area;
  }
  Distortion result;
  Sums whole;
  for (const Sums& part : parts) whole.area += part.area;
  resize(result.triangle, triangles.size(), 0);
  for (std::size_t t = 0; t < maps.size(); ++t) {
    Sums& part = parts[component_of(t)];
    const double scale = part.uv_area > 0 ? std::sqrt(part.area / part.uv_area) : 1;
    add(maps[t], scale, part);
    add(maps[t], scale, whole);
    result.triangle.angle[t] = static_cast<float>(maps[t].angle);
    result.triangle.area[t] =
        static_cast<float>(maps[t].area > 0 ? maps[t].uv_area / maps[t].area * scale * scale : 1);
    result.triangle.stretch[t] = static_cast<float>(std::sqrt(maps[t].square) / scale);
    result.triangle.max_stretch[t] = static_cast<float>(std::sqrt(maps[t].most) / scale);
  }
  spread_to_points(triangles, maps, points.size(), result);
  result.whole = whole.summary();
  for (const Sums& part : parts) result.components.push_back(part.summary());
  return result;
}

}  // namespace rimline
