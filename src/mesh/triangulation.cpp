// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangulation.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace rimline {

Triangulation triangulation_of(std::vector<Triangle> triangles, Index vertex_count) {
  Triangulation mesh;
  mesh.triangles = std::move(triangles);
  mesh.adjacent.assign(mesh.triangles.size(), {none, none, none});
  // The directed edges that leave each vertex, in one array.
  std::vector<Index> offsets(vertex_count + 1, 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) ++offsets[v + 1];
  }
  for (Index v = 0; v < vertex_count; ++v) offsets[v + 1] += offsets[v];
  struct Leaving {
    Index to, triangle;
  };
  std::vector<Leaving> leaving(offsets[vertex_count]);
  std::vector<Index> at(offsets.begin(), offsets.end() - 1);
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) leaving[at[mesh.triangles[t][c]]++] = {mesh.triangles[t][next(c)], t};
  }
  run_slices(0, mesh.triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t) {
      for (int c = 0; c < 3; ++c) {
        const Index from = mesh.triangles[t][next(c)], to = mesh.triangles[t][previous(c)];
        for (Index e = offsets[to]; e < offsets[to + 1]; ++e) {
          if (leaving[e].to == from) mesh.adjacent[t][c] = leaving[e].triangle;
        }
      }
    }
  });
  return mesh;
}

namespace {

// A triangle, found by one of its edges.
struct Side {
  Index low, high, triangle;
  friend auto operator<=>(const Side&, const Side&) = default;
};

}  // namespace

Triangulation link_triangles(std::vector<Triangle> triangles) {
  Triangulation mesh{std::move(triangles), {}};
  mesh.adjacent.assign(mesh.triangles.size(), {none, none, none});
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (Index t = 0; t < mesh.size(); ++t) {
    const Triangle& x = mesh.triangles[t];
    for (int c = 0; c < 3; ++c) sides.push_back({std::min(x[c], x[next(c)]), std::max(x[c], x[next(c)]), t});
  }
  std::ranges::sort(sides);
  for (std::size_t s = 1; s < sides.size(); ++s) {
    const Side &one = sides[s - 1], &other = sides[s];
    if (one.low != other.low || one.high != other.high) continue;
    mesh.adjacent[one.triangle][mesh.corner_opposite(one.triangle, one.low, one.high)] = other.triangle;
    mesh.adjacent[other.triangle][mesh.corner_opposite(other.triangle, one.low, one.high)] = one.triangle;
  }
  return mesh;
}

void split(Triangulation& mesh, Index triangle, Index vertex) {
  const Triangle v = mesh.triangles[triangle];
  const std::array<Index, 3> beyond = mesh.adjacent[triangle];
  const Index second = mesh.size(), third = second + 1;
  mesh.triangles[triangle] = {vertex, v[0], v[1]};
  mesh.triangles.push_back({vertex, v[1], v[2]});
  mesh.triangles.push_back({vertex, v[2], v[0]});
  mesh.adjacent[triangle] = {beyond[2], second, third};
  mesh.adjacent.push_back({beyond[0], third, triangle});
  mesh.adjacent.push_back({beyond[1], triangle, second});
  if (beyond[0] != none) mesh.adjacent[beyond[0]][mesh.corner_across(beyond[0], triangle)] = second;
  if (beyond[1] != none) mesh.adjacent[beyond[1]][mesh.corner_across(beyond[1], triangle)] = third;
}

}  // namespace rimline
