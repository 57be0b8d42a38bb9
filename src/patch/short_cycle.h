// SPDX-License-Identifier: GPL-3.0-or-later
// Short closed curves that do not bound: a handle or a one-sided strip has them, a disc with holes has none.
#pragma once

#include <vector>

#include "mesh/editable_mesh.h"

namespace rimline {

// A component and its rims, which are taken to be capped: `rim_of` has the number of a rim at its vertices
// and none elsewhere.
struct Capped {
  const EditableMesh& mesh;
  const std::vector<Index>& rim_of;
};

// Closed curves by the shortest-path tree of one vertex: one for each of the first Betti number (mod 2) of
// the capped component, all through the vertex, the shortest first.
struct CyclesAt {
  std::vector<Index> shortest;  // vertices in order, simple; empty where every closed curve bounds
  std::vector<Index> others;    // one vertex on each of the others
};

// Tree-cotree decomposition (Eppstein 2003) with the greedy choice of Erickson and Whittlesey (2005): the
// shortest curve is the shortest through the vertex that bounds no part of the surface. Lengths are counted
// in edges. Time linear in the component's triangles.
CyclesAt cycles_at(const Capped& surface, Index vertex);

// Paths through the surface between two of the given vertices, all on one rim, that do not bound when closed
// over the rim's cap: across the bands that make handles or one-sided strips. One for each of the first Betti
// number, the shortest first, without those that end where they begin. Otherwise like cycles_at().
std::vector<std::vector<Index>> arcs_at(const Capped& surface, const std::vector<Index>& ends);

}  // namespace rimline
