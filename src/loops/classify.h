// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops are boundaries, and which of these are the outer ones.
#pragma once

#include <vector>

#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"

namespace rimline {

struct ClassifiedLoops {
  std::vector<Loop> boundaries;  // by component, the outer one first, holes by falling length
  std::vector<Loop> gaps;        // too short, too improbable, of a small component, or not asked for
};

// The outer loop of a component is the boundary of the largest extent, weighted up where the surface is
// inside it and down where it is around it. `components`: by number.
ClassifiedLoops classify_loops(const std::vector<Loop>& loops,
                               const std::vector<SurfaceComponent>& components, const RimEvidence& evidence,
                               const BoundaryLoopOptions& options);

// The gaps that would be boundaries by less strict options (model::doubtful_gap, model::doubtful_least): the
// likeliest first.
std::vector<Loop> doubtful_gaps(const std::vector<Loop>& gaps,
                                const std::vector<SurfaceComponent>& components,
                                const BoundaryLoopOptions& options);

// Whether most of so many points lie on closed surfaces: neither boundaries nor doubtful gaps were found.
bool is_closed(const std::vector<Loop>& boundaries, const std::vector<Loop>& doubtful,
               const std::vector<SurfaceComponent>& components, std::size_t points);

}  // namespace rimline
