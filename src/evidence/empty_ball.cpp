// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/empty_ball.h"

#include <algorithm>
#include <cmath>

#include "base/model.h"

namespace rimline {

double empty_ball_radius(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         Index a, Index b, Index inner) {
  constexpr double most = model::ball_largest;
  const double h = std::max(spacing[a], spacing[b]);
  const Point middle = 0.5 * (points[a] + points[b]);
  const double half_squared = squared_distance(points[a], points[b]) / 4;
  const Point along = (0.5 / std::sqrt(half_squared)) * (points[b] - points[a]);
  Point out = middle - points[inner];
  out = out - dot(out, along) * along;
  out = (1 / std::max(norm(out), 1e-300)) * out;
  // A ball with centre middle + s * out through both ends also passes through q for this s.
  double nearest = most * h;
  for (const Index end : {a, b}) {
    for (const Index q : neighbours.of(end)) {
      if (q == a || q == b || q == inner) continue;
      const Point d = points[q] - middle;
      const double ahead = dot(out, d);
      if (ahead > 1e-6 * h) nearest = std::min(nearest, (dot(d, d) - half_squared) / (2 * ahead));  // [guard]
    }
  }
  return nearest <= 0 ? 0 : std::min(most, std::sqrt(nearest * nearest + half_squared) / h);
}

}  // namespace rimline
