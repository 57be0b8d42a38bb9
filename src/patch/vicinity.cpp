// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/vicinity.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "patch/short_cycle.h"
#include "patch/surgery.h"

namespace rimline {
namespace {

using Numbers = std::map<Index, Index>;  // of the vertices of the whole

std::vector<Index> vertices_within(const EditableMesh& mesh, Index vertex, int edges, Numbers& number) {
  std::vector<Index> vertices{vertex};
  number.emplace(vertex, 0);
  std::size_t begin = 0;
  for (int ring = 0; ring < edges; ++ring) {
    for (const std::size_t end = vertices.size(); begin < end; ++begin) {
      for (const Index w : mesh.neighbours(vertices[begin])) {
        if (number.emplace(w, static_cast<Index>(vertices.size())).second) vertices.push_back(w);
      }
    }
  }
  return vertices;
}

// The triangles of which all corners are numbered.
std::vector<Triangle> triangles_of(const EditableMesh& mesh, const std::vector<Index>& vertices,
                                   const Numbers& number) {
  std::vector<Triangle> triangles;
  for (const Index v : vertices) {
    for (const Index t : mesh.star(v)) {
      const Triangle& whole = mesh.triangle(t);
      if (v != *std::ranges::min_element(whole)) continue;
      const auto a = number.find(whole[0]), b = number.find(whole[1]), c = number.find(whole[2]);
      if (a == number.end() || b == number.end() || c == number.end()) continue;
      triangles.push_back({a->second, b->second, c->second});
    }
  }
  return triangles;
}

// Keeps the largest fan at each vertex: the part stays a surface.
void drop_lesser_fans(EditableMesh& mesh) {
  for (bool again = true; std::exchange(again, false);) {
    for (Index v = 0; v < mesh.vertices(); ++v) {
      const std::vector<Fan> fans = mesh.fans(v);
      if (fans.size() < 2) continue;
      const auto most =
          std::ranges::max_element(fans, {}, [](const Fan& fan) { return fan.triangles.size(); });
      for (auto fan = fans.begin(); fan != fans.end(); ++fan) {
        if (fan == most) continue;
        for (const Index t : fan->triangles) mesh.remove(t);
      }
      again = true;
    }
  }
}

std::vector<Index> in_whole(const Vicinity& vicinity, std::vector<Index> curve) {
  for (Index& v : curve) v = vicinity.vertices[v];
  return curve;
}

}  // namespace

Vicinity vicinity_of(const EditableMesh& mesh, Index vertex, int edges) {
  Numbers number;
  std::vector<Index> vertices = vertices_within(mesh, vertex, edges, number);
  std::vector<Point> points;
  for (const Index v : vertices) points.push_back(mesh.points()[v]);
  EditableMesh part(points, triangles_of(mesh, vertices, number));
  drop_lesser_fans(part);
  Rims rims(vertices.size());
  for (const Rim& rim : walk_rims(part)) rims.put(rim);
  return {std::move(vertices), std::move(points), std::move(part), std::move(rims.of)};
}

std::vector<Index> short_cycle_in(const Vicinity& vicinity) {
  const Capped surface{vicinity.mesh, vicinity.rim_of};
  std::vector<Index> shortest = cycles_at(surface, 0).shortest;
  // Searches from a vertex of the shortest curve so far, until the curves get no shorter.
  for (bool shorter = !shortest.empty(); std::exchange(shorter, false);) {
    for (const Index v : std::vector<Index>(shortest)) {
      std::vector<Index> other = cycles_at(surface, v).shortest;
      if (other.empty() || other.size() >= shortest.size()) continue;
      shortest = std::move(other);
      shorter = true;
      break;
    }
  }
  return in_whole(vicinity, std::move(shortest));
}

std::vector<std::vector<Index>> more_cycles_in(const Vicinity& vicinity) {
  constexpr std::size_t looked_at = 24;  // vertices: two rings or so
  std::set<std::vector<Index>> found;
  for (Index v = 0; v < static_cast<Index>(std::min(looked_at, vicinity.vertices.size())); ++v) {
    std::vector<Index> cycle = cycles_at({vicinity.mesh, vicinity.rim_of}, v).shortest;
    if (!cycle.empty()) found.insert(in_whole(vicinity, std::move(cycle)));
  }
  std::vector<std::vector<Index>> cycles(found.begin(), found.end());
  std::ranges::stable_sort(cycles, {}, &std::vector<Index>::size);
  return cycles;
}

std::vector<std::vector<Index>> arcs_in(const Vicinity& vicinity, const std::vector<Index>& rim_of) {
  // Vertices on a rim of the whole, by the rim of the vicinity and that of the whole.
  std::map<std::pair<Index, Index>, std::vector<Index>> ends;
  for (std::size_t v = 0; v < vicinity.vertices.size(); ++v) {
    const Index rim = rim_of[vicinity.vertices[v]];
    if (rim != none && vicinity.rim_of[v] != none)
      ends[{vicinity.rim_of[v], rim}].push_back(static_cast<Index>(v));
  }
  std::vector<std::vector<Index>> arcs;
  for (const auto& [rims, vertices] : ends) {
    for (std::vector<Index>& arc : arcs_at({vicinity.mesh, vicinity.rim_of}, vertices))
      arcs.push_back(in_whole(vicinity, std::move(arc)));
  }
  std::ranges::stable_sort(arcs, {}, &std::vector<Index>::size);
  return arcs;
}

}  // namespace rimline
