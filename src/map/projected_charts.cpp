// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/projected_charts.h"

#include <cmath>
#include <utility>

#include "base/vec.h"
#include "map/bisect.h"

namespace rimline {
namespace {

Point normal_of(const OpenMesh& open, Index t) {
  return unit(triangle_normal(open.points, open.mesh.triangles[t]));
}

// The chart of each triangle, by the first of its triangles.
std::vector<Index> grown_charts(const OpenMesh& whole) {
  constexpr double least_cosine = 0.25;
  std::vector<Index> label(whole.mesh.triangles.size(), none), queue;
  for (Index first = 0; first < whole.mesh.size(); ++first) {
    if (label[first] != none) continue;
    const Point up = normal_of(whole, first);
    label[first] = first;
    queue.assign(1, first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Index other : whole.mesh.adjacent[queue[i]]) {
        if (other == none || label[other] != none || dot(normal_of(whole, other), up) < least_cosine)
          continue;
        label[other] = first;
        queue.push_back(other);
      }
    }
  }
  return label;
}

// Along `up`, of length 1: seen from its tip triangles that face it are counter-clockwise.
std::vector<UV> projected(const std::vector<Point>& points, Point up) {
  const Point off = std::abs(up.x) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
  const Point u = unit(cross(off, up)), v = cross(up, u);
  std::vector<UV> uv;
  for (const Point p : points) uv.push_back({dot(p - points.front(), u), dot(p - points.front(), v)});
  return uv;
}

struct Piece {
  OpenMesh open;
  Point up;
};

}  // namespace

bool is_tangled(const OpenMesh& whole) {
  constexpr Index vertices_a_handle = 100, few = 8;
  return whole.genus > few && whole.genus > whole.vertices() / vertices_a_handle;
}

std::optional<std::vector<Chart>> projected_charts(const OpenMesh& whole, const Run& run) {
  std::vector<Chart> charts;
  std::vector<Piece> left;
  for (OpenMesh& open : open_parts(whole, grown_charts(whole))) {
    const Point up = normal_of(open, 0);
    left.push_back({std::move(open), up});
    while (!left.empty()) {
      run.check_cancel();
      Piece piece = std::move(left.back());
      left.pop_back();
      Chart chart{std::move(piece.open), {}, 0};
      chart.map = given_chart(chart.open, projected(chart.open.points, piece.up));
      if (chart.map) {
        charts.push_back(std::move(chart));
        continue;
      }
      if (chart.open.mesh.size() == 1) return {};
      for (OpenMesh& part : halves(chart.open, 0)) left.push_back({std::move(part), piece.up});
    }
  }
  return charts;
}

}  // namespace rimline
