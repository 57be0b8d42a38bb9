// SPDX-License-Identifier: GPL-3.0-or-later
// Short curves of small handles, found in a part of the surface.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// The part of a mesh within some edges of a vertex, with ids of its own. Each vertex has one fan; all rims
// are taken to be capped. The vertex is 0.
struct Vicinity {
  std::vector<Index> vertices;  // in ids of the whole, by distance
  std::vector<Point> points;
  EditableMesh mesh;
  std::vector<Index> rim_of;  // the number of a rim of `mesh`, none elsewhere
};

Vicinity vicinity_of(const EditableMesh& mesh, Index vertex, int edges);

// The shortest closed curve that does not bound in the vicinity, in ids of the whole; empty where every one
// bounds. It does not bound in the whole surface either, because another curve crosses it once.
std::vector<Index> short_cycle_in(const Vicinity& vicinity);

// The shortest such curves through each of the vertices nearest to the middle, the shortest first, to try
// where the first one fails.
std::vector<std::vector<Index>> more_cycles_in(const Vicinity& vicinity);

// Paths between two vertices on one rim of the whole, likewise: across bands that are parts of handles or of
// one-sided strips. `rim_of`: of the whole.
std::vector<std::vector<Index>> arcs_in(const Vicinity& vicinity, const std::vector<Index>& rim_of);

}  // namespace rimline
