// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/cut_graph.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/union_find.h"
#include "map/seam_paths.h"

namespace rimline {
namespace {

// A side that is no edge of the tree, and the length of the closed curve that it closes.
struct Chord {
  double length;
  Index triangle;
  int corner;
};

Cuts no_cuts(const OpenMesh& open) { return Cuts(open.mesh.triangles.size(), {0, 0, 0}); }

std::pair<Index, Index> ends_of(const OpenMesh& open, Index t, int c) {
  const Triangle& v = open.mesh.triangles[t];
  return {v[next(c)], v[previous(c)]};
}

// Each edge once, the longest curves first.
std::vector<Chord> chords_of(const OpenMesh& open, const SeamPaths& paths) {
  std::vector<Chord> chords;
  for (Index t = 0; t < open.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = open.mesh.adjacent[t][c];
      if (other != none && other < t) continue;
      const auto [a, b] = ends_of(open, t, c);
      if (paths.via[a] == b || paths.via[b] == a) continue;
      chords.push_back({paths.cost[a] + paths.cost[b] + seam_cost(open, t, c), t, c});
    }
  }
  std::ranges::sort(chords, [](const Chord& x, const Chord& y) {
    return std::tie(y.length, x.triangle, x.corner) < std::tie(x.length, y.triangle, y.corner);
  });
  return chords;
}

// The chords that no spanning tree of the triangles and caps crosses; the shortest curve last.
std::vector<Chord> generators(const OpenMesh& open, const SeamPaths& paths) {
  std::vector<Index> cap(open.points.size(), none);
  for (std::size_t l = 0; l < open.loops.size(); ++l) {
    for (const Index v : open.loops[l].points) cap[v] = static_cast<Index>(l);
  }
  UnionFind faces(open.mesh.triangles.size() + open.loops.size());
  std::vector<Chord> left;
  for (const Chord& chord : chords_of(open, paths)) {
    const Index other = open.mesh.adjacent[chord.triangle][chord.corner];
    const Index rim = cap[ends_of(open, chord.triangle, chord.corner).first];
    if (!faces.join(chord.triangle, other != none ? other : open.mesh.size() + rim)) left.push_back(chord);
  }
  return left;
}

// Removes edges that end at a vertex with no other one, until there is none.
std::vector<std::pair<Index, Index>> pruned(std::vector<std::pair<Index, Index>> edges, Index vertices) {
  for (auto& [a, b] : edges) {
    if (a > b) std::swap(a, b);
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<int> degree(vertices, 0);
  for (const auto& [a, b] : edges) ++degree[a], ++degree[b];
  for (bool again = true; again;) {
    again = std::erase_if(edges, [&](const auto& edge) {
              const bool ends = degree[edge.first] == 1 || degree[edge.second] == 1;
              if (ends) --degree[edge.first], --degree[edge.second];
              return ends;
            }) > 0;
  }
  return edges;
}

Cuts cuts_along(const OpenMesh& open, const std::vector<std::pair<Index, Index>>& sorted_edges) {
  Cuts cuts = no_cuts(open);
  std::vector<char> touched(open.points.size(), 0);
  for (const auto& [a, b] : sorted_edges) touched[a] = touched[b] = 1;
  for (Index t = 0; t < open.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [from, to] = ends_of(open, t, c);
      if (!touched[from] || !touched[to]) continue;
      const std::pair<Index, Index> edge = std::minmax(from, to);
      cuts[t][c] = std::ranges::binary_search(sorted_edges, edge);
    }
  }
  return cuts;
}

}  // namespace

Cuts cut_handles(const OpenMesh& open) {
  if (open.genus <= 0) return no_cuts(open);
  const Graph graph = seam_graph(open);
  SeamPaths paths = paths_to(graph, 0);
  const std::vector<Chord> first = generators(open, paths);
  const Index root = ends_of(open, first.back().triangle, first.back().corner).first;
  paths = paths_to(graph, root);
  std::vector<std::pair<Index, Index>> edges;
  for (const Chord& chord : generators(open, paths)) {
    const auto [a, b] = ends_of(open, chord.triangle, chord.corner);
    edges.emplace_back(a, b);
    for (Index v : {a, b}) {
      for (; paths.via[v] != none; v = paths.via[v]) edges.emplace_back(v, paths.via[v]);
    }
  }
  return cuts_along(open, pruned(std::move(edges), open.vertices()));
}

Cuts slit(const OpenMesh& open, Index vertex, const std::vector<Index>& to) {
  const SeamPaths paths = paths_to(seam_graph(open), vertex);
  Index end = farthest(paths);
  if (!to.empty()) {
    end = *std::ranges::min_element(
        to, [&](Index a, Index b) { return std::tie(paths.cost[a], a) < std::tie(paths.cost[b], b); });
  }
  std::vector<std::pair<Index, Index>> edges;
  for (Index v = end; paths.via[v] != none; v = paths.via[v]) edges.push_back(std::minmax(v, paths.via[v]));
  if (to.empty() && edges.size() < 2) edges.clear();
  std::ranges::sort(edges);
  return cuts_along(open, edges);
}

}  // namespace rimline
