// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes a subset of the points of a surface with the loops that bound it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "patch/partition.h"
#include "rimline/refine_surface.h"

namespace rimline {

// One component, or the reason why it was not meshed.
struct Component {
  std::vector<Index> points;  // the id of each in the whole, ascending
  std::vector<Loop> loops;    // of the mesh, the outer one first, in ids of its own
  Patch patch;                // likewise
  bool orientable = true;
  int genus = 0;
  std::vector<HandleRepair> repairs;  // in ids of the whole
  std::string failure;                // empty where it was meshed
};

// The whole surface that parts are taken from.
struct Whole {
  Points points;
  const Neighbours& neighbours;
  std::span<const double> spacing;  // one per point
};

struct PartTriangles {
  const std::vector<Triangle>& triangles;  // in ids of the part
  bool end_at_loops;                       // whether the loops were found on them
};

// Meshes a part: as a disc with holes over all of its points where it is one, otherwise each of its
// components as the manifold that its triangles make. Every component is a manifold that ends at its loops,
// or has a failure. options.corners are ids of the whole; throws BadOption where they are on several parts.
std::vector<Component> mesh_part(const Whole& whole, const PatchInput& part, const PartTriangles& survey,
                                 const RefineOptions& options, const Run& run);

}  // namespace rimline
