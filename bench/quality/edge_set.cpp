// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/edge_set.h"

#include <algorithm>
#include <unordered_map>

#include "base/union_find.h"

namespace rimline::bench {

EdgeSet make_set(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

EdgeSet edges_of_loop(std::span<const Index> loop) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < loop.size(); ++i)
    edges.push_back(Edge::of(loop[i], loop[(i + 1) % loop.size()]));
  return make_set(std::move(edges));
}

std::size_t count_common(const EdgeSet& a, const EdgeSet& b) {
  std::size_t common = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    const auto order = *i <=> *j;
    common += order == 0;
    if (order <= 0) ++i;
    if (order >= 0) ++j;
  }
  return common;
}

MeshEdges edges_of_mesh(const std::vector<Triangle>& mesh) {
  std::vector<Edge> all;
  all.reserve(3 * mesh.size());
  for (const Triangle& t : mesh) {
    for (int i = 0; i < 3; ++i) all.push_back(Edge::of(t[i], t[(i + 1) % 3]));
  }
  std::sort(all.begin(), all.end());
  MeshEdges result;
  for (const Edge& e : all) {
    if (result.edges.empty() || result.edges.back() != e) {
      result.edges.push_back(e);
      result.triangles.push_back(0);
    }
    ++result.triangles.back();
  }
  return result;
}

EdgeSet boundary_of(const MeshEdges& mesh) {
  EdgeSet boundary;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    if (mesh.triangles[i] == 1) boundary.push_back(mesh.edges[i]);
  }
  return boundary;
}

std::vector<EdgeSet> connected_pieces(const EdgeSet& edges) {
  if (edges.empty()) return {};
  Index most = 0;
  for (const Edge& e : edges) most = std::max(most, e.b);
  UnionFind groups(most + 1);
  for (const Edge& e : edges) groups.join(e.a, e.b);
  std::vector<EdgeSet> pieces;
  std::unordered_map<Index, std::size_t> piece_of;
  for (const Edge& e : edges) {
    const auto [place, is_new] = piece_of.try_emplace(groups.find(e.a), pieces.size());
    if (is_new) pieces.emplace_back();
    pieces[place->second].push_back(e);
  }
  return pieces;
}

}  // namespace rimline::bench
