// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/outline_first.h"

#include <cmath>

#include "base/vec.h"
#include "map/mesh_system.h"

namespace rimline {

std::vector<UV> closed_outline(const std::vector<double>& lengths, const std::vector<double>& turning) {
  const std::size_t n = lengths.size();
  std::vector<UV> direction(n);
  double angle = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) angle += turning[i];
    direction[i] = {std::cos(angle), std::sin(angle)};
  }
  // Minimizes the sum of (change of a length)^2 / length: changes are length * (direction, m) with one vector
  // m.
  double uu = 0, u_v = 0, vv = 0;
  UV gap;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [c, s] = direction[i];
    uu += lengths[i] * c * c, u_v += lengths[i] * c * s, vv += lengths[i] * s * s;
    gap = gap + lengths[i] * direction[i];
  }
  const double det = uu * vv - u_v * u_v;
  UV m;
  if (det > 0) m = {(gap.u * vv - gap.v * u_v) / det, (gap.v * uu - gap.u * u_v) / det};
  std::vector<UV> places(n);
  UV at;
  for (std::size_t i = 0; i < n; ++i) {
    places[i] = at;
    const double change = direction[i].u * m.u + direction[i].v * m.v;
    at = at + (lengths[i] * (1 - change)) * direction[i];
  }
  return places;
}

MapSummary map_outline_first(const OpenMesh& open, const std::vector<double>& turning, double residual,
                             std::vector<UV>& uv, const Run& run) {
  const std::vector<Index>& outline = open.loops.front().points;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < outline.size(); ++i)
    lengths.push_back(distance(open.points[outline[i]], open.points[outline[next_in(i, outline.size())]]));
  const std::vector<UV> places = closed_outline(lengths, turning);
  uv.assign(open.points.size() + open.loops.size() - 1, {});
  std::vector<char> fixed(uv.size(), 0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    uv[outline[i]] = places[i];
    fixed[outline[i]] = 1;
  }
  const MapSummary summary =
      solve_system(mesh_system(open.points, open.mesh, open.loops, {}, fixed, uv, run), residual, uv, run);
  uv.resize(open.points.size());
  return summary;
}

}  // namespace rimline
