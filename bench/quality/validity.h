// SPDX-License-Identifier: GPL-3.0-or-later
// Is what a method gave a mesh, and of the right topology? With nothing of the library.
#pragma once

#include <string>
#include <vector>

#include "quality/method.h"

namespace rimline::bench {

// "", or the first rule that is broken: triangles of three different vertices, none twice, two at most at an
// edge, one fan at a vertex; where loops came with it, triangles that face alike where that can be, and open
// edges that are the loops'; where uv came with it, of
// each component for all of its triangles or for none, and none turned over.
std::string fault_in(const Outcome& outcome, std::size_t points);

struct Topology {
  long long euler = 0;
  std::size_t components = 0, loops = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};
Topology topology_of(const std::vector<Triangle>& mesh);

// Share of the points that are in no triangle.
double share_unused(const std::vector<Triangle>& mesh, std::size_t points);

}  // namespace rimline::bench
