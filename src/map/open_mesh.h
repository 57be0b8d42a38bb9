// SPDX-License-Identifier: GPL-3.0-or-later
// A surface cut open: a mesh in which the two sides of a cut have separate vertices.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/points.h"

namespace rimline {

struct OpenMesh {
  std::vector<Point> points;
  Triangulation mesh;           // each vertex has one fan
  std::vector<Index> vertex;    // of the surface, for each vertex of this mesh
  std::vector<Index> triangle;  // likewise for each triangle
  std::vector<Loop> loops;      // its boundary, the mesh on the left, the longest first
  Index genus = 0;              // handles

  Index vertices() const { return static_cast<Index>(points.size()); }
};

// Per triangle and side (opposite to the corner of that number), 1 where the surface is cut along it. Set on
// either side of an edge, it counts for both.
using Cuts = std::vector<std::array<char, 3>>;

// The whole surface, cut where it must be to become orientable: `triangles` may be one-sided; the triangles
// of the result agree. Each edge has at most two triangles.
OpenMesh open_surface(Points points, const std::vector<Triangle>& triangles);

// Parts of an open mesh, cut along `cuts` and where neighbours have different labels. One for each group of
// triangles that hang together over sides without a cut, in the order of their first triangles. Vertices and
// triangles are those of the surface that `whole` was cut from.
std::vector<OpenMesh> open_parts(const OpenMesh& whole, const std::vector<Index>& label, const Cuts& cuts);
// The same, cut where labels differ alone.
std::vector<OpenMesh> open_parts(const OpenMesh& whole, const std::vector<Index>& label);

// Some triangles of an open mesh, by ascending positions in it, as a mesh. They need not be connected.
OpenMesh open_selection(const OpenMesh& whole, const std::vector<Index>& triangles);

}  // namespace rimline
