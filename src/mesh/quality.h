// SPDX-License-Identifier: GPL-3.0-or-later
// Quality of the edges of a mesh, the objective of the refinement.
#pragma once

#include <span>

#include "mesh/triangulation.h"
#include "rimline/run.h"

namespace rimline {

struct EdgeQuality {
  double length = 0;  // of all inner edges together
  std::size_t bad =
      0;  // inner edges longer than 3 spacings of either end, or folded by more than 120 degrees
};

EdgeQuality edge_quality(Points points, const Triangulation& mesh, std::span<const double> spacing,
                         const Run& run = {});

}  // namespace rimline
