// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/angle_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/vec.h"
#include "map/domain.h"
#include "map/free_chart.h"
#include "mesh/corner_angles.h"

namespace rimline {
namespace {

std::array<double, 3> angles_in_space(const OpenMesh& open, const Triangle& t) {
  return corner_angles(open.points[t[0]], open.points[t[1]], open.points[t[2]]);
}

Point in_space(UV p) { return {p.u, p.v, 0}; }

// At each point of the outline, inside of the polygon that the disc's map has there.
std::vector<double> polygon_angles(const OpenMesh& open) {
  const std::vector<Index>& outline = open.loops.front().points;
  std::vector<UV> uv(open.points.size());
  place_outline(open.points, outline, Domain::Disc, std::array{none, none, none, none}, uv);
  const std::size_t n = outline.size();
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i) {
    const Point at = in_space(uv[outline[i]]), before = in_space(uv[outline[(i + n - 1) % n]]);
    const Point after = in_space(uv[outline[next_in(i, n)]]);
    angles.push_back(corner_angles(at, after, before)[0]);  // convex, so below pi
  }
  return angles;
}

}  // namespace

AngleError angle_error(const OpenMesh& open, const std::vector<UV>& uv) {
  AngleError error;
  double area = 0;
  for (const Triangle& t : open.mesh.triangles) {
    const auto space = angles_in_space(open, t);
    const auto flat = corner_angles(in_space(uv[t[0]]), in_space(uv[t[1]]), in_space(uv[t[2]]));
    const double own = triangle_area(open.points, t);
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += std::abs(space[c] - flat[c]) / 3;
    error.corner += sum;
    error.area += own * sum;
    area += own;
  }
  error.corner /= static_cast<double>(std::max<std::size_t>(1, open.mesh.triangles.size()));
  error.area = area > 0 ? error.area / area : 0;
  return error;
}

AngleError least_error_of_disc(const OpenMesh& open) {
  std::vector<double> lack(open.points.size(), 2 * std::numbers::pi);
  std::vector<double> least(open.points.size(), std::numeric_limits<double>::infinity());
  const std::vector<double> outline = polygon_angles(open);
  for (std::size_t i = 0; i < outline.size(); ++i) lack[open.loops.front().points[i]] = outline[i];
  double area = 0;
  for (const Triangle& t : open.mesh.triangles) {
    const auto space = angles_in_space(open, t);
    const double own = triangle_area(open.points, t);
    area += own;
    for (int c = 0; c < 3; ++c) {
      lack[t[c]] -= space[c];
      least[t[c]] = std::min(least[t[c]], own);
    }
  }
  for (std::size_t h = 1; h < open.loops.size(); ++h) {
    for (const Index v : open.loops[h].points) lack[v] = 0;  // rims of holes have any angle
  }
  AngleError error;
  for (std::size_t v = 0; v < lack.size(); ++v) {
    if (!std::isfinite(least[v])) continue;
    error.corner += std::abs(lack[v]);
    error.area += std::abs(lack[v]) * least[v];
  }
  error.corner /= 3 * static_cast<double>(std::max<std::size_t>(1, open.mesh.triangles.size()));
  error.area = area > 0 ? error.area / (3 * area) : 0;
  return error;
}

bool is_above(const AngleError& error, const AngleError& other) {
  constexpr double rounding = 1e-9;  // radians
  return error.corner > other.corner + rounding || error.area > other.area + rounding;
}

AngleError error_of_disc(const OpenMesh& open, double residual, const Run& run) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto disc = disc_chart(open, residual, run);
  return disc ? angle_error(open, disc->uv) : AngleError{infinite, infinite};
}

}  // namespace rimline
