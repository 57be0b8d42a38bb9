// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rimline::cli {

void put_boundary_columns(Cloud& cloud, const BoundaryResult& result) {
  set_column(cloud, make_column("boundary", result.boundary));
  set_column(cloud, make_column("loop", result.loop));
  set_column(cloud, make_column("candidate", result.candidate));
  set_column(cloud, make_column("p_value", result.p_value));
  set_column(cloud, make_column("score", result.score));
  if (!result.chromosome.empty()) set_column(cloud, make_column("chromosome", result.chromosome));
  if (result.label.empty()) return;
  std::vector<std::uint8_t> label(result.label.size());
  std::transform(result.label.begin(), result.label.end(), label.begin(),
                 [](PointLabel l) { return static_cast<std::uint8_t>(l); });
  set_column(cloud, make_column("boundary_probability", result.boundary_probability));
  set_column(cloud, make_column("label", label));
}

namespace {

template <class T>
void append_value(std::vector<std::byte>& bytes, T value) {
  const auto* from = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof(T));
}

void append_unknown(Column& column) {
  constexpr auto nan = std::numeric_limits<double>::quiet_NaN();
  switch (column.type) {
    case Scalar::Float32: return append_value(column.bytes, static_cast<float>(nan));
    case Scalar::Float64: return append_value(column.bytes, nan);
    default: column.bytes.resize(column.bytes.size() + size_in_bytes(column.type));
  }
}

}  // namespace

void add_fill_vertices(Cloud& cloud, const std::vector<Point>& added, BoundaryResult& boundary) {
  constexpr auto nan = std::numeric_limits<double>::quiet_NaN();
  cloud.points.insert(cloud.points.end(), added.begin(), added.end());
  for (Column& column : cloud.columns) {
    for (std::size_t i = 0; i < added.size(); ++i) append_unknown(column);
  }
  const std::size_t count = cloud.points.size();
  boundary.boundary.resize(count, 0);
  boundary.loop.resize(count, none);
  boundary.candidate.resize(count, 0);
  boundary.p_value.resize(count, nan);
  boundary.score.resize(count, nan);
  if (boundary.label.empty()) return;
  boundary.boundary_probability.resize(count, 0);
  boundary.label.resize(count, PointLabel::Interior);
}

std::vector<Column> distortion_columns(const Distortion::Values& values) {
  return {make_column("angle_distortion", values.angle), make_column("area_distortion", values.area),
          make_column("stretch_l2", values.stretch), make_column("stretch_linf", values.max_stretch)};
}

void put_map_columns(Cloud& cloud, const std::vector<UV>& uv, const std::vector<std::uint8_t>& boundary) {
  std::vector<double> u(uv.size()), v(uv.size());
  std::transform(uv.begin(), uv.end(), u.begin(), [](UV p) { return p.u; });
  std::transform(uv.begin(), uv.end(), v.begin(), [](UV p) { return p.v; });
  set_column(cloud, make_column("u", u));
  set_column(cloud, make_column("v", v));
  set_column(cloud, make_column("boundary", boundary));
}

}  // namespace rimline::cli
