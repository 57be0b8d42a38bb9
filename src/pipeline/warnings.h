// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings about a mesh, one line of each kind.
#pragma once

#include <string>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {

// Components that are suspect, failed or were repaired.
std::vector<std::string> warn_of_components(const std::vector<PatchReport>& patches);

// Gaps that may be boundaries.
std::vector<std::string> warn_of_doubtful(const std::vector<DoubtfulGap>& gaps,
                                          const BoundaryLoopOptions& options);

// Components that have another map than the one wanted, or none.
std::vector<std::string> warn_of_maps(const std::vector<ComponentSummary>& components, Domain wanted);

// Above this many median spacings an edge is far longer than the sample asks for.
constexpr double far_longer = 6;

// Edges that are far longer than the median spacing.
std::vector<std::string> warn_of_long_edges(double longest_over_median);

}  // namespace rimline::pipeline
