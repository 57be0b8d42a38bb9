// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of the mesh with a reference.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/measure.h"

namespace rimline::pipeline {

struct ReferenceMeasures {
  std::optional<ReferenceSummary> whole;                   // none without a reference
  std::vector<std::optional<DistanceSummary>> components;  // of each component that was meshed
};

ReferenceMeasures measure_reference(const PreparedPoints& prepared, const MappedMesh& mesh,
                                    const Reference& reference, const Run& run);

}  // namespace rimline::pipeline
