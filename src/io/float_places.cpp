// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/float_places.h"

#include <cmath>
#include <limits>

namespace rimline::io {

Box box_of(Points points) {
  Box box;
  for (const Point& p : points) {
    if (!is_finite(p)) continue;
    if (box.empty()) box = {p, p};
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

namespace {

Point as_floats(Point p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

}  // namespace

Point offset_for_floats(const Cloud& cloud) {
  constexpr double allowed = 1e-6;
  const Box box = box_of(cloud.points);
  if (box.empty() || cloud.coordinate_type == Scalar::Float32) return {};
  const double diagonal = norm(box.high - box.low);
  double lost = 0;
  for (const Point& p : cloud.points) {
    if (is_finite(p)) lost = std::max(lost, norm(as_floats(p) - p));
  }
  if (!(lost > allowed * diagonal)) return {};
  // To a digit of the diagonal's size, in decimal: 5400000.8, not 5400000.800000001.
  const double digit = std::floor(std::log10(diagonal));
  const double step = std::pow(10.0, std::abs(digit));
  const auto round = [&](double low, double high) {
    const double middle = low + (high - low) / 2;
    const double rounded = digit < 0 ? std::round(middle * step) / step : std::round(middle / step) * step;
    return std::isfinite(rounded) ? rounded : low;
  };
  return {round(box.low.x, box.high.x), round(box.low.y, box.high.y), round(box.low.z, box.high.z)};
}

void check_floats(const MeshToWrite& mesh, Point offset, const std::string& format) {
  const auto& points = mesh.cloud.points;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Point a = points[t[c]], b = points[t[(c + 1) % 3]];
      const Point as_a = as_floats(a - offset), as_b = as_floats(b - offset);
      const bool held = is_finite(as_a) && is_finite(as_b) && (as_a != as_b || a == b);
      if (held) continue;
      throw Error(ErrorCode::CannotWrite,
                  format +
                      " has 32 bits a coordinate, which can not tell apart two corners of a triangle or hold "
                      "them; write PLY or OBJ instead",
                  {t[c], t[(c + 1) % 3]});
    }
  }
}

}  // namespace rimline::io
