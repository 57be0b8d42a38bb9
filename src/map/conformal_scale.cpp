// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/conformal_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/vec.h"
#include "map/mesh_system.h"
#include "mesh/corner_angles.h"

namespace rimline {
namespace {

// Angle defects: 2 pi (pi on loops) less the angles of the triangles; on holes with the share of the disc
// that closes them. Then one entry per hole.
std::vector<double> curvature_of(const OpenMesh& open) {
  constexpr double pi = std::numbers::pi;
  std::vector<double> lack(open.points.size() + open.loops.size() - 1, 0);
  std::fill(lack.begin(), lack.begin() + open.vertices(), 2 * pi);
  for (const Loop& loop : open.loops) {
    for (const Index v : loop.points) lack[v] = pi;
  }
  for (const auto& [a, b, c] : open.mesh.triangles) {
    const auto angles = corner_angles(open.points[a], open.points[b], open.points[c]);
    lack[a] -= angles[0], lack[b] -= angles[1], lack[c] -= angles[2];
  }
  for (std::size_t h = 1; h < open.loops.size(); ++h) {
    for (const Index v : open.loops[h].points)
      lack[v] += 2 * pi / static_cast<double>(open.loops[h].points.size());
  }
  return lack;
}

double mean_of(double square, double inverse, double area) {
  return std::sqrt(square / area) * std::sqrt(inverse / area);
}

}  // namespace

std::vector<double> conformal_log_scale(const OpenMesh& open, double residual, std::vector<double>& turning,
                                        const Run& run) {
  const std::vector<Index>& outline = open.loops.front().points;
  const std::vector<double> lack = curvature_of(open);
  std::vector<char> fixed(lack.size(), 0);
  for (const Index v : outline) fixed[v] = 1;
  std::vector<UV> u(lack.size());
  MapSystem system = mesh_system(open.points, open.mesh, open.loops, {}, fixed, u, run);
  for (std::size_t node = 0; node < lack.size(); ++node) {
    if (system.unknown[node] != none) system.right[system.unknown[node]] = {-lack[node], 0};
  }
  solve_system(std::move(system), residual, u, run);
  // On the outline, where u is 0, L u is minus the weighted sum of u of the neighbours.
  std::fill(fixed.begin(), fixed.end(), 0);
  const MapSystem all = mesh_system(open.points, open.mesh, open.loops, {}, fixed, u, run);
  turning.clear();
  for (const Index v : outline)
    turning.push_back(lack[v] + all.matrix.diagonal[v] * u[v].u + all.matrix.off_diagonal(v, u.data()).u);
  std::vector<double> log_scale;
  for (Index v = 0; v < open.vertices(); ++v) log_scale.push_back(u[v].u);
  return log_scale;
}

Stretch stretch_of_scale(const OpenMesh& open, const std::vector<double>& log_scale) {
  double area = 0, square = 0, inverse = 0, most = 0;
  for (const Triangle& t : open.mesh.triangles) {
    const double own = triangle_area(open.points, t);
    const double scale = std::exp((log_scale[t[0]] + log_scale[t[1]] + log_scale[t[2]]) / 3);
    area += own;
    square += own * scale * scale;
    inverse += own / (scale * scale);
    most = std::max(most, 1 / scale);
  }
  if (!(area > 0)) return {};
  return {mean_of(square, inverse, area), most * std::sqrt(square / area)};
}

Stretch stretch_of_map(const OpenMesh& open, const std::vector<UV>& uv) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double area = 0, flat = 0, square = 0, most = 0;
  for (const Triangle& t : open.mesh.triangles) {
    const Point e = open.points[t[1]] - open.points[t[0]], f = open.points[t[2]] - open.points[t[0]];
    const UV s = uv[t[1]] - uv[t[0]], r = uv[t[2]] - uv[t[0]];
    const double own = 0.5 * norm(cross(e, f)), twice = s.u * r.v - s.v * r.u;
    if (!(twice > 0)) return {infinite, infinite};
    // The map from uv to space is linear; a, b, c are its metric in uv.
    const Point du = (1 / twice) * (r.v * e - s.v * f), dv = (1 / twice) * (s.u * f - r.u * e);
    const double a = dot(du, du), b = dot(du, dv), c = dot(dv, dv);
    area += own;
    flat += twice / 2;
    square += own * (a + c) / 2;
    if (own > 0) most = std::max(most, (a + c + std::sqrt((a - c) * (a - c) + 4 * b * b)) / 2);
  }
  if (!(area > 0)) return {};
  const double scale = std::sqrt(flat / area);
  return {std::sqrt(square / area) * scale, std::sqrt(most) * scale};
}

}  // namespace rimline
