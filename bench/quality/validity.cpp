// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/validity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/union_find.h"
#include "quality/edge_set.h"
#include "quality/fans.h"

namespace rimline::bench {
namespace {

bool has_sound_corners(const std::vector<Triangle>& mesh, std::size_t points) {
  std::set<std::set<Index>> seen;
  return std::ranges::all_of(mesh, [&](const Triangle& t) {
    const std::set<Index> corners(t.begin(), t.end());
    return corners.size() == 3 && *corners.begin() >= 0 &&
           static_cast<std::size_t>(*corners.rbegin()) < points && seen.insert(corners).second;
  });
}

// The component of each point that a triangle has.
std::vector<Index> components_of(const std::vector<Triangle>& mesh, std::size_t points) {
  UnionFind joined(points);
  for (const Triangle& t : mesh) {
    joined.join(t[0], t[1]);
    joined.join(t[1], t[2]);
  }
  std::vector<Index> component(points, none);
  for (const Triangle& t : mesh) {
    for (const Index v : t) component[v] = joined.find(v);
  }
  return component;
}

bool has_sound_uv(const Outcome& outcome) {
  const std::vector<Index> component = components_of(outcome.mesh, outcome.uv.size());
  std::set<Index> with, without;
  for (std::size_t k = 0; k < outcome.mesh.size(); ++k) {
    const Triangle& t = outcome.mesh[k];
    const auto [a, b, c] = outcome.corner_uv[k];
    const double area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    (std::isnan(area) ? without : with).insert(component[t[0]]);
    if (area <= 0) return false;
  }
  return std::ranges::none_of(with, [&](Index c) { return without.contains(c); });
}

// Whether each component that can be oriented is: an edge of two triangles is run through both ways.
bool faces_alike(const std::vector<Triangle>& mesh) {
  std::map<std::pair<Index, Index>, std::pair<std::size_t, bool>> first;  // triangle at an edge, runs it up
  UnionFind turned(2 * mesh.size());  // each triangle as it is, and turned
  std::vector<std::size_t> against;   // triangles at edges run the same way
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index a = mesh[t][c], b = mesh[t][(c + 1) % 3];
      const auto [at, is_new] = first.emplace(std::minmax(a, b), std::pair(t, a < b));
      if (is_new) continue;
      const auto [other, up] = at->second;
      const bool alike = up != (a < b);
      if (!alike) against.push_back(t);
      turned.join(t, alike ? other : other + mesh.size());
      turned.join(t + mesh.size(), alike ? other + mesh.size() : other);
    }
  }
  return std::ranges::all_of(against, [&](std::size_t t) {
    return turned.find(t) == turned.find(t + mesh.size());  // one-sided
  });
}

EdgeSet edges_of_loops(const LoopIds& loops) {
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    const EdgeSet own = edges_of_loop(loop);
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return make_set(std::move(edges));
}

}  // namespace

std::string fault_in(const Outcome& outcome, std::size_t points) {
  if (outcome.mesh.empty()) return "no triangle";
  if (!has_sound_corners(outcome.mesh, points)) return "corners";
  const MeshEdges edges = edges_of_mesh(outcome.mesh);
  if (std::ranges::any_of(edges.triangles, [](int count) { return count > 2; })) return "edges";
  if (count_nonmanifold_vertices(outcome.mesh) > 0) return "fans";
  if (outcome.has_loops && !faces_alike(outcome.mesh)) return "facing";
  if (outcome.has_loops && boundary_of(edges) != edges_of_loops(outcome.loops)) return "loops";
  if (!outcome.corner_uv.empty() && !has_sound_uv(outcome)) return "uv";
  return "";
}

Topology topology_of(const std::vector<Triangle>& mesh) {
  Index most = -1;
  for (const Triangle& t : mesh) most = std::max({most, t[0], t[1], t[2]});
  const std::vector<Index> component = components_of(mesh, static_cast<std::size_t>(most + 1));
  const auto used = static_cast<long long>(component.size()) - std::ranges::count(component, none);
  const MeshEdges edges = edges_of_mesh(mesh);
  std::set<Index> components(component.begin(), component.end());
  components.erase(none);
  return {used - static_cast<long long>(edges.edges.size()) + static_cast<long long>(mesh.size()),
          components.size(), connected_pieces(boundary_of(edges)).size()};
}

double share_unused(const std::vector<Triangle>& mesh, std::size_t points) {
  std::vector<char> used(points, 0);
  for (const Triangle& t : mesh) used[t[0]] = used[t[1]] = used[t[2]] = 1;
  return points == 0 ? 0 : static_cast<double>(std::ranges::count(used, 0)) / static_cast<double>(points);
}

}  // namespace rimline::bench
