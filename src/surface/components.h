// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components and sides of a set of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

struct Components {
  std::vector<Index> of_triangle;        // component of each selected triangle, else `none`
  std::vector<std::uint8_t> turned;      // per triangle, 1 where it has to be turned over to agree
  std::vector<std::uint8_t> orientable;  // per component
  Index count() const { return static_cast<Index>(orientable.size()); }
};

// Numbers the components of the selected triangles (two that share an edge are in one) in the order of their
// first triangles, and tells which triangles have to be turned so that neighbours agree; where that can not
// be (a Moebius strip) they agree as far as a walk from the first comes. Blocks of triangles are walked side
// by side and joined after; the result does not depend on the blocks. The component's mean normal gets a
// positive z (or y, or x where those before vanish).
Components find_components(const TriangleSet& set, const Selection& selected, const Run& run = {});

// The set with the marked triangles turned over.
TriangleSet turn_over(TriangleSet set, const std::vector<std::uint8_t>& marked, const Run& run = {});

}  // namespace rimline
