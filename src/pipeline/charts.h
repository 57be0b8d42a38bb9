// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of the map.
#pragma once

#include "pipeline/mapped_mesh.h"

namespace rimline::pipeline {

// Maps the components that are left to map_by_charts(): all for the domain Free, and of the others those that
// have no map. Numbers all charts, lays them side by side and gives them the size that is asked for.
// Triangles of one-sided components are turned so that each runs counter-clockwise in its chart.
MappedMesh map_charts(MappedMesh mesh, const ParameterizeOptions& options, const Run& run);

}  // namespace rimline::pipeline
