// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/seam_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "base/vec.h"

namespace rimline {

double seam_cost(const OpenMesh& open, Index triangle, int corner) {
  constexpr double of_ridge = 1, of_valley = 0.5;  // added or subtracted for a right angle, in lengths
  const Triangulation& mesh = open.mesh;
  const Triangle& t = mesh.triangles[triangle];
  const Point a = open.points[t[next(corner)]], b = open.points[t[previous(corner)]];
  const double length = norm(b - a);
  const Index other = mesh.adjacent[triangle][corner];
  if (other == none) return length;
  const Point apex = open.points[t[corner]];
  const Point beyond = open.points[mesh.triangles[other][mesh.corner_across(other, triangle)]];
  const Point n = triangle_normal(apex, a, b), m = triangle_normal(beyond, b, a);
  const double size = norm(n) * norm(m);
  if (!(size > 0)) return length;
  const double turn = std::acos(std::clamp(dot(n, m) / size, -1.0, 1.0)) / (std::numbers::pi / 2);
  // Summed over both sides, so that the result is the same from either.
  const bool valley = dot(n, beyond - a) / norm(n) + dot(m, apex - a) / norm(m) > 0;
  return length * (valley ? 1 - of_valley * std::min(turn, 1.0) : 1 + of_ridge * turn);
}

Graph seam_graph(const OpenMesh& open) {
  std::vector<WeightedEdge> edges;
  for (Index t = 0; t < open.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = open.mesh.adjacent[t][c];
      if (other != none && other < t) continue;  // visited from the other side
      const Triangle& v = open.mesh.triangles[t];
      edges.push_back({v[next(c)], v[previous(c)], seam_cost(open, t, c)});
    }
  }
  return make_graph(open.vertices(), edges);
}

SeamPaths paths_to(const Graph& graph, Index source) {
  SeamPaths paths;
  paths.cost.assign(graph.size(), std::numeric_limits<double>::infinity());
  paths.via.assign(graph.size(), none);
  paths.cost[source] = 0;
  using Reached = std::pair<double, Index>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.emplace(0, source);
  while (!open.empty()) {
    const auto [cost, v] = open.top();
    open.pop();
    if (cost > paths.cost[v]) continue;
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const Index w = graph.neighbours[e];
      const double through = cost + graph.weights[e];
      const bool nearer = through < paths.cost[w];
      // Edges without length must not cause cycles.
      const bool as_near = through == paths.cost[w] && cost < through && v < paths.via[w];
      if (!nearer && !as_near) continue;
      paths.cost[w] = through;
      paths.via[w] = v;
      if (nearer) open.emplace(through, w);
    }
  }
  return paths;
}

Index farthest(const SeamPaths& paths) {
  Index far = 0;
  for (Index v = 1; v < static_cast<Index>(paths.cost.size()); ++v) {
    if (std::isfinite(paths.cost[v]) && paths.cost[v] > paths.cost[far]) far = v;
  }
  return far;
}

}  // namespace rimline
