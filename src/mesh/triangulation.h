// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh structure: triangles with their neighbours.
#pragma once

#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// The next and the one before, of three corners.
constexpr int next(int corner) { return corner == 2 ? 0 : corner + 1; }
constexpr int previous(int corner) { return corner == 0 ? 2 : corner - 1; }

// Triangles of which each edge has one or two. Corner c of a triangle is opposite to the edge from corner
// next(c) to previous(c), beyond which lies adjacent[t][c], or none at the boundary.
struct Triangulation {
  std::vector<Triangle> triangles;
  std::vector<std::array<Index, 3>> adjacent;

  Index size() const { return static_cast<Index>(triangles.size()); }
  int corner_of(Index triangle, Index vertex) const {
    const Triangle& t = triangles[triangle];
    return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  }
  // The corner of `triangle` opposite to its edge between a and b.
  int corner_opposite(Index triangle, Index a, Index b) const {
    const Triangle& t = triangles[triangle];
    return t[0] != a && t[0] != b ? 0 : t[1] != a && t[1] != b ? 1 : 2;
  }
  // The corner of `triangle` opposite to the edge that it shares with `other`.
  int corner_across(Index triangle, Index other) const {
    const std::array<Index, 3>& a = adjacent[triangle];
    return a[0] == other ? 0 : a[1] == other ? 1 : 2;
  }
};

// Whether a triangle runs along its edge from a to b, not from b to a.
inline bool runs(const Triangle& t, Index a, Index b) {
  return ((t[0] == a) & (t[1] == b)) | ((t[1] == a) & (t[2] == b)) | ((t[2] == a) & (t[0] == b));
}

// Finds the neighbours. Requires consistent orientation, and at most two triangles at an edge.
Triangulation triangulation_of(std::vector<Triangle> triangles, Index vertex_count);

// The same for triangles of any orientation.
Triangulation link_triangles(std::vector<Triangle> triangles);

// Splits a triangle in three at a new vertex. The first part takes its place, the others are appended.
void split(Triangulation& mesh, Index triangle, Index vertex);

}  // namespace rimline
