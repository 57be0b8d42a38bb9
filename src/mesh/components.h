// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components of triangles, and how their triangles lie to each other.
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

// Numbers the components of the selected triangles, or of all where `selected` is empty. Two triangles that
// are adjacent are in one component; the numbers ascend with the first triangles. Tells which triangles have
// to be turned so that neighbours agree with the first of the component; where that can not be (a Moebius
// strip) they agree as far as a walk from the first comes. Neighbours need not agree in orientation as given.
// Blocks of triangles are walked in parallel and joined after; the result does not depend on the blocks.
//
// The one walk for components: to part them elsewhere, clear `adjacent` of the mesh there.
Components find_components(const Triangulation& mesh, std::span<const std::uint8_t> selected = {},
                           const Run& run = {});

}  // namespace rimline
