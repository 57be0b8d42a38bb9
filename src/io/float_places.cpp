// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/float_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rimline::io {

void Box::add(Point p) {
  if (!is_finite(p)) return;
  if (empty()) low = high = p;
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

Box box_of_corners(const MeshToWrite& mesh) {
  Box box;
  for (const Triangle& t : mesh.triangles) {
    for (const Index id : t) box.add(mesh.cloud.points[id]);
  }
  if (!mesh.triangles.empty()) return box;
  for (const Point& p : mesh.cloud.points) box.add(p);
  return box;
}

bool floats_hold(Point p) {
  constexpr double most = std::numeric_limits<float>::max();
  return std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most;
}

Point as_floats(Point p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Point offset_for_floats(const MeshToWrite& mesh) {
  constexpr double allowed = 1e-6;
  const Box box = box_of_corners(mesh);
  if (box.empty() || mesh.cloud.coordinate_type == Scalar::Float32) return {};
  const double diagonal = norm(box.high - box.low);
  double lost = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const Index id : t) {
      const Point p = mesh.cloud.points[id];
      lost = std::max(lost, floats_hold(p) ? norm(as_floats(p) - p) : norm(p));
    }
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

void check_floats(const MeshToWrite& mesh, Point offset, const std::string& what) {
  const auto& points = mesh.cloud.points;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Point a = points[t[c]], b = points[t[(c + 1) % 3]];
      const bool held = floats_hold(a - offset) && floats_hold(b - offset);
      if (held && (a == b || as_floats(a - offset) != as_floats(b - offset))) continue;
      throw Error(ErrorCode::CannotWrite,
                  what +
                      " has 32 bits a coordinate, which can not tell apart two corners of a triangle or hold "
                      "them; write PLY or OBJ instead",
                  {t[c], t[(c + 1) % 3]});
    }
  }
}

}  // namespace rimline::io
