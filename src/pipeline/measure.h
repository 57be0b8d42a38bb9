// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the mesh for the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/measure.h"

namespace rimline::pipeline {

struct Measures {
  MeshSummary mesh;                          // the whole
  Distortion distortion;                     // in ids of the arrangement
  std::vector<ComponentSummary> components;  // those of the mesh, each measured by itself
  std::size_t self_intersections = 0;
  bool more_self_intersections = false;       // counting stopped at this number
  double longest_edge = 0;                    // over the median spacing
  std::optional<ReferenceSummary> reference;  // where there is one
  std::size_t unmeshed = 0;                   // used points in no triangle
  std::vector<std::string> warnings;
};

// Measures the whole, each component, and the distance to the reference where there is one.
Measures measure(const PreparedPoints& prepared, const MappedMesh& mesh, const Reference& reference,
                 const Run& run, StageClock& clock);

}  // namespace rimline::pipeline
