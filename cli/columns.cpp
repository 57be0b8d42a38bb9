// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.h"

#include <algorithm>

namespace rimline::cli {

void put_boundary_columns(Cloud& cloud, const BoundaryResult& result) {
  set_column(cloud, make_column("boundary", result.boundary));
  set_column(cloud, make_column("loop", result.loop));
  set_column(cloud, make_column("candidate", result.candidate));
  set_column(cloud, make_column("p_value", result.p_value));
  set_column(cloud, make_column("score", result.score));
  if (result.label.empty()) return;
  std::vector<std::uint8_t> label(result.label.size());
  std::transform(result.label.begin(), result.label.end(), label.begin(),
                 [](PointLabel l) { return static_cast<std::uint8_t>(l); });
  set_column(cloud, make_column("boundary_probability", result.boundary_probability));
  set_column(cloud, make_column("label", label));
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
