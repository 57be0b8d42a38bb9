// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.h"

#include <algorithm>
#include <utility>

namespace rimline::cli {

void put_column(Cloud& cloud, Column column) {
  std::erase_if(cloud.columns, [&](const Column& old) { return old.name == column.name; });
  cloud.columns.push_back(std::move(column));
}

void put_boundary_columns(Cloud& cloud, const BoundaryResult& result) {
  put_column(cloud, make_column("boundary", result.boundary));
  put_column(cloud, make_column("loop", result.loop));
  put_column(cloud, make_column("candidate", result.candidate));
  put_column(cloud, make_column("p_value", result.p_value));
  put_column(cloud, make_column("score", result.score));
}

void put_map_columns(Cloud& cloud, const std::vector<UV>& uv, const std::vector<std::uint8_t>& boundary) {
  std::vector<double> u(uv.size()), v(uv.size());
  std::transform(uv.begin(), uv.end(), u.begin(), [](UV p) { return p.u; });
  std::transform(uv.begin(), uv.end(), v.begin(), [](UV p) { return p.v; });
  put_column(cloud, make_column("u", u));
  put_column(cloud, make_column("v", v));
  put_column(cloud, make_column("boundary", boundary));
}

}  // namespace rimline::cli
