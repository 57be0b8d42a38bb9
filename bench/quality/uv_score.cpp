// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/uv_score.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/union_find.h"

namespace rimline::bench {
namespace {

double signed_area(const std::array<UV, 3>& t) {
  return (t[1].u - t[0].u) * (t[2].v - t[0].v) - (t[1].v - t[0].v) * (t[2].u - t[0].u);
}

double angle_error(Points points, const Triangle& t, const std::array<UV, 3>& flat) {
  const auto space = angles_of(points[t[0]], points[t[1]], points[t[2]]);
  const auto plane =
      angles_of({flat[0].u, flat[0].v, 0}, {flat[1].u, flat[1].v, 0}, {flat[2].u, flat[2].v, 0});
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::abs(space[i] - plane[i]);
  return sum;
}

}  // namespace

std::array<double, 3> angles_of(Point a, Point b, Point c) {
  const auto angle = [](Point apex, Point p, Point q) {
    return std::atan2(norm(cross(p - apex, q - apex)), dot(p - apex, q - apex));
  };
  return {angle(a, b, c), angle(b, c, a), angle(c, a, b)};
}

Metrics score_uv(Points points, const std::vector<Triangle>& mesh, std::span<const UV> uv) {
  UnionFind groups(points.size());
  for (const Triangle& t : mesh) {
    groups.join(t[0], t[1]);
    groups.join(t[0], t[2]);
  }
  struct Turned {
    std::size_t not_left = 0, not_right = 0;
  };
  std::map<Index, Turned> components;  // each may be mirrored as a whole
  std::size_t not_finite = 0;
  double error = 0;
  for (const Triangle& t : mesh) {
    const std::array<UV, 3> flat{uv[t[0]], uv[t[1]], uv[t[2]]};
    const double area = signed_area(flat);
    if (!std::isfinite(area)) {
      ++not_finite;
      continue;
    }
    Turned& turned = components[groups.find(t[0])];
    turned.not_left += area <= 0;
    turned.not_right += area >= 0;
    error += angle_error(points, t, flat);
  }
  std::size_t flips = not_finite;
  for (const auto& [group, turned] : components) flips += std::min(turned.not_left, turned.not_right);
  Metrics m{{"uv_flipped_triangles", static_cast<double>(flips)}};
  if (not_finite < mesh.size()) {
    m["uv_mean_angle_error_rad"] = error / (3.0 * static_cast<double>(mesh.size() - not_finite));
  }
  return m;
}

}  // namespace rimline::bench
