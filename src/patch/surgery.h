// SPDX-License-Identifier: GPL-3.0-or-later
// Removes triangles along a curve, so that a surface becomes simpler.
#pragma once

#include <optional>
#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// Vertices in order, each joined to the next by an edge; where it is closed the last to the first, too.
struct Curve {
  std::vector<Index> vertices;
  bool is_closed = true;
};

using Rim = std::vector<Index>;

// The rim of each vertex.
struct Rims {
  std::vector<Index> of;  // none inside
  Index count = 0;        // numbers given so far
  std::size_t steps = 0;  // vertices of rims that cuts walked along so far

  explicit Rims(std::size_t vertices) : of(vertices, none) {}
  void put(const Rim& rim);
};

// Removed and added triangles.
struct Change {
  std::vector<Triangle> removed;
  std::vector<Index> added;  // places
};

// The change along the curve that removes least: the triangles on one of its sides, or all at it where its
// sides overlap. For each rim that was there before the longest of the new rims stays, the others are closed.
// Each vertex has one fan afterwards. None, with the mesh unchanged, where more than `most` triangles would
// be removed, or added at one rim, where two rims would merge, or where no change leaves a manifold.
std::optional<Change> cut(EditableMesh& mesh, Rims& rims, const Curve& curve, std::size_t most);

}  // namespace rimline
