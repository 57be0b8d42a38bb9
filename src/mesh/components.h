// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components of triangles, and their orientation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangulation.h"
#include "rimline/run.h"

namespace rimline {

struct Components {
  std::vector<Index> of_triangle;        // component of each selected triangle, else `none`
  std::vector<std::uint8_t> turned;      // per triangle, 1 where it has to be turned over to agree
  std::vector<std::uint8_t> orientable;  // per component
  Index count() const { return static_cast<Index>(orientable.size()); }
};

// Numbers the components of the selected triangles, or of all where `selected` is empty. Adjacent triangles
// are in one component; components are numbered by their first triangles. Tells which triangles must be
// turned so that neighbours agree with the first triangle of the component. On a one-sided surface (a Moebius
// strip) they agree along the walk from the first triangle. The given orientations are arbitrary. Blocks of
// triangles are walked in parallel and joined afterwards; the result does not depend on the blocks.
//
// All rooms use this walk. To stop it at an edge, clear `adjacent` of the mesh on both sides.
Components find_components(const Triangulation& mesh, std::span<const std::uint8_t> selected = {},
                           const Run& run = {});

}  // namespace rimline
