// SPDX-License-Identifier: GPL-3.0-or-later
// The topology of the surface of the points, without a map: a map to the disc makes a disc of anything.
#pragma once

#include <vector>

#include "local/star.h"
#include "rimline/mesh.h"

namespace rimline {

// Of the largest edge-connected part of the triangles on which the cells of all three corners agree, its
// gaps closed by discs.
struct Topology {
  bool orientable = true;
  int genus = 0;        // handles; of a one-sided surface half the number of cross-caps, rounded down
  double coverage = 0;  // share of the points in that part: near 0 the result means nothing
  Index triangles = 0;
};

// The triangles that the stars of all three corners name. At most two of them share an edge.
std::vector<Triangle> agreed_triangles(const Stars& stars);

Topology find_topology(Points points, const Stars& stars);

}  // namespace rimline
