// SPDX-License-Identifier: GPL-3.0-or-later
// Short curves of small handles, found without a look at the whole surface.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// What lies within some edges of a vertex, as a mesh with ids of its own: each vertex has one fan, all rims
// are taken to be capped. The vertex is 0.
struct Vicinity {
  std::vector<Index> vertices;  // in ids of the whole, by distance
  std::vector<Point> points;
  EditableMesh mesh;
  std::vector<Index> rim_of;  // the number of a rim of `mesh`, none elsewhere
};

Vicinity vicinity_of(const EditableMesh& mesh, Index vertex, int edges);

// The shortest closed curve that bounds nothing in the vicinity, in ids of the whole; empty where every one
// bounds. It bounds nothing in the whole surface either, for another one crosses it once.
std::vector<Index> short_cycle_in(const Vicinity& vicinity);

// The shortest through each of the vertices nearest to the middle, likewise, the shortest first, where that
// one does not serve.
std::vector<std::vector<Index>> more_cycles_in(const Vicinity& vicinity);

// Ways between two vertices on one rim of the whole, likewise: across bands that are parts of handles or of
// one-sided strips. `rim_of` is that of the whole.
std::vector<std::vector<Index>> arcs_in(const Vicinity& vicinity, const std::vector<Index>& rim_of);

}  // namespace rimline
