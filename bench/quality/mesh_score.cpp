// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/mesh_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "quality/fans.h"
#include "quality/self_intersections.h"
#include "quality/uv_score.h"

namespace rimline::bench {
namespace {

constexpr double sliver = 10 * std::numbers::pi / 180;
constexpr double overlong = 3;  // spacings

bool is_degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

double share_of_slivers(Points points, const std::vector<Triangle>& mesh) {
  const auto slivers = std::count_if(mesh.begin(), mesh.end(), [&](const Triangle& t) {
    const auto a = angles_of(points[t[0]], points[t[1]], points[t[2]]);
    return *std::min_element(a.begin(), a.end()) < sliver;
  });
  return mesh.empty() ? 0 : static_cast<double>(slivers) / static_cast<double>(mesh.size());
}

double share_of_long_edges(const Case& c, const MeshEdges& edges) {
  std::size_t inner = 0, many = 0;
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    if (edges.triangles[i] != 2) continue;
    const Edge e = edges.edges[i];
    ++inner;
    many += distance(c.points[e.a], c.points[e.b]) > overlong * std::max(c.spacing[e.a], c.spacing[e.b]);
  }
  return inner == 0 ? 0 : static_cast<double>(many) / static_cast<double>(inner);
}

std::size_t count_conflicts(const std::vector<Triangle>& mesh) {
  std::vector<std::pair<Index, Index>> directed;
  for (const Triangle& t : mesh) {
    for (int i = 0; i < 3; ++i) directed.emplace_back(t[i], t[(i + 1) % 3]);
  }
  std::sort(directed.begin(), directed.end());
  const auto end = std::unique(directed.begin(), directed.end());
  return static_cast<std::size_t>(directed.end() - end);
}

std::size_t count_used(const std::vector<Triangle>& mesh, std::size_t points) {
  std::vector<char> used(points, 0);
  for (const Triangle& t : mesh) {
    for (const Index id : t) used[id] = 1;
  }
  return std::count(used.begin(), used.end(), 1);
}

bool has_degree_two(const EdgeSet& boundary) {
  std::vector<Index> ends;
  for (const Edge& e : boundary) ends.insert(ends.end(), {e.a, e.b});
  std::sort(ends.begin(), ends.end());
  for (auto i = ends.begin(); i != ends.end();) {
    const auto next = std::upper_bound(i, ends.end(), *i);
    if (next - i != 2) return false;
    i = next;
  }
  return true;
}

Metrics score_topology(const Case& c, const std::vector<Triangle>& mesh, const MeshEdges& edges) {
  Metrics m;
  const EdgeSet boundary = boundary_of(edges);
  const auto used = static_cast<double>(count_used(mesh, c.points.size()));
  m["faces"] = static_cast<double>(mesh.size());
  m["points_used"] = used / static_cast<double>(c.points.size());
  m["degenerate_faces"] = static_cast<double>(std::count_if(mesh.begin(), mesh.end(), is_degenerate));
  m["nonmanifold_edges"] = static_cast<double>(
      std::count_if(edges.triangles.begin(), edges.triangles.end(), [](int n) { return n > 2; }));
  m["nonmanifold_vertices"] = static_cast<double>(count_nonmanifold_vertices(mesh));
  m["orientation_conflicts"] = static_cast<double>(count_conflicts(mesh));
  m["components"] = static_cast<double>(connected_pieces(edges.edges).size());
  m["euler"] = used - static_cast<double>(edges.edges.size()) + static_cast<double>(mesh.size());
  m["boundary_loops"] = static_cast<double>(connected_pieces(boundary).size());
  m["boundary_degree_two"] = has_degree_two(boundary);
  return m;
}

double f1_of_sets(const EdgeSet& found, const EdgeSet& truth) {
  return f1_of(count_common(found, truth), found.size(), truth.size()).f1;
}

bool same_topology(const Metrics& mesh, const Metrics& truth) {
  const auto same = [&](const char* what) { return mesh.at(what) == truth.at(what); };
  return same("euler") && same("components") && same("boundary_loops") && mesh.at("nonmanifold_edges") == 0 &&
         mesh.at("nonmanifold_vertices") == 0;
}

void score_against_truth(const Case& c, const std::vector<Triangle>& mesh, const MeshEdges& edges,
                         Metrics& m) {
  const MeshEdges truth = edges_of_mesh(c.mesh);
  m["edges_agree"] = f1_of_sets(edges.edges, truth.edges);
  if (!c.flipped.empty()) m["edges_agree_flipped"] = f1_of_sets(edges.edges, edges_of_mesh(c.flipped).edges);
  const EdgeSet found_rim = boundary_of(edges), true_rim = boundary_of(truth);
  const F1 rim = f1_of(count_common(found_rim, true_rim), found_rim.size(), true_rim.size());
  m["boundary_edges_precision"] = rim.precision;
  m["boundary_edges_recall"] = rim.recall;
  m["boundary_edges_f1"] = rim.f1;
  m["area_over_truth"] = area_of(c.points, mesh) / area_of(c.points, c.mesh);
  m["edges_longer_than_3_spacings_in_truth"] = share_of_long_edges(c, truth);
  m["min_angle_below_10deg_in_truth"] = share_of_slivers(c.points, c.mesh);
  const Metrics true_topology = score_topology(c, c.mesh, truth);
  m["loops_true"] = true_topology.at("boundary_loops");
  m["euler_true"] = true_topology.at("euler");
  m["topology_right"] = same_topology(m, true_topology);
  m["self_intersections_in_truth"] = static_cast<double>(count_self_intersections(c.points, c.mesh));
}

void score_boundary_points(const Case& c, const EdgeSet& boundary, Metrics& m) {
  std::vector<Index> ids;
  for (const Edge& e : boundary) ids.insert(ids.end(), {e.a, e.b});
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto is_true = [&](Index id) { return c.boundary[id] == 1; };
  const std::size_t truth = std::count(c.boundary.begin(), c.boundary.end(), 1);
  const std::size_t common = std::count_if(ids.begin(), ids.end(), is_true);
  m["boundary_points_f1"] = f1_of(common, ids.size(), truth).f1;
}

}  // namespace

double area_of(Points points, const std::vector<Triangle>& mesh) {
  double area = 0;
  for (const Triangle& t : mesh) {
    area += norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2;
  }
  return area;
}

Metrics score_mesh(const Case& c, const std::vector<Triangle>& mesh, std::span<const UV> uv) {
  if (mesh.empty()) return {{"faces", 0}};
  const MeshEdges edges = edges_of_mesh(mesh);
  Metrics m = score_topology(c, mesh, edges);
  m["min_angle_below_10deg"] = share_of_slivers(c.points, mesh);
  m["edges_longer_than_3_spacings"] = share_of_long_edges(c, edges);
  m["self_intersections"] = static_cast<double>(count_self_intersections(c.points, mesh));
  if (!c.mesh.empty()) score_against_truth(c, mesh, edges, m);
  if (!c.boundary.empty()) score_boundary_points(c, boundary_of(edges), m);
  if (!uv.empty()) m.merge(score_uv(c.points, mesh, uv));
  return m;
}

Metrics score_rim(const std::vector<Triangle>& mesh, const LoopIds& loops) {
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    const EdgeSet of_loop = edges_of_loop(loop);
    edges.insert(edges.end(), of_loop.begin(), of_loop.end());
  }
  std::sort(edges.begin(), edges.end());
  return {{"boundary_is_loops", edges == boundary_of(edges_of_mesh(mesh))}};
}

}  // namespace rimline::bench
