// SPDX-License-Identifier: GPL-3.0-or-later
// From points to a map of their surface to the plane.
#pragma once

#include <vector>

#include "rimline/find_boundary.h"
#include "rimline/map_to_disc.h"  // for one release: map_to_disc() was declared here


namespace rimline {

struct ParameterizeResult {
  BoundaryResult boundary;
  std::vector<UV> uv;
};

// The loops and the map. Throws also NoClosedLoop, UnreachableInterior, NotADisc, NoConvergence.
ParameterizeResult parameterize(Points points, const Options& options, const Run& run,
                                const Given& given = {});

}  // namespace rimline
