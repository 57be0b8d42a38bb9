// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.h"

#include <algorithm>

namespace rimline {
namespace {

Point normal_of(Points points, const Triangle& t) {
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

bool folded(Point a, Point b) {
  const double d = dot(a, b);
  return d < 0 && d * d > 0.25 * dot(a, a) * dot(b, b);
}

}  // namespace

EdgeQuality edge_quality(Points points, const Triangulation& mesh, std::span<const double> spacing) {
  EdgeQuality quality;
  for (Index t = 0; t < mesh.size(); ++t) {
    const Triangle& v = mesh.triangles[t];
    const Point normal = normal_of(points, v);
    for (int c = 0; c < 3; ++c) {
      const Index other = mesh.adjacent[t][c];
      if (other == none || other > t) continue;
      const Index a = v[next(c)], b = v[previous(c)];
      const double length = distance(points[a], points[b]);
      quality.length += length;
      if (length > 3 * std::max(spacing[a], spacing[b]) ||
          folded(normal, normal_of(points, mesh.triangles[other])))
        ++quality.bad;
    }
  }
  return quality;
}

}  // namespace rimline
