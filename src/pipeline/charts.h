// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of the map.
#pragma once

#include "pipeline/mapped_mesh.h"

namespace rimline::pipeline {

// Maps the remaining components by map_by_charts(): all for the domain Free, and of the others those without
// a map. Numbers all charts, places them side by side and scales them as asked. Triangles of one-sided
// components are turned so that each runs counter-clockwise in its chart.
MappedMesh map_charts(MappedMesh mesh, const ParameterizeOptions& options, const Run& run);

}  // namespace rimline::pipeline
