// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/mean_direction.h"

#include <algorithm>

#include "base/vec.h"

namespace rimline {

Point tangent_direction(const Point& vector, const Point& normal) {
  const Point along = vector - dot(vector, normal) * normal;
  const double length = norm(along);
  return length > 0 ? (1 / length) * along : Point{};
}

Point mean_direction(const Samples& samples, Index point, int count) {
  const int known = std::min(count, samples.neighbours.k);
  Point sum;
  for (const Index i : samples.neighbours.of(point, known)) {
    sum = sum + tangent_direction(samples.points[i] - samples.points[point], samples.frames[point].normal);
  }
  return (1.0 / known) * sum;
}

}  // namespace rimline
