// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops are boundaries, and which of these are the outer ones.
#pragma once

#include <vector>

#include "evidence/rim_probability.h"
#include "rimline/boundary_loops.h"

namespace rimline {

struct ClassifiedLoops {
  std::vector<Loop> boundaries;  // by component, the outer one first, holes by falling length
  std::vector<Loop> gaps;        // too short, too improbable, of a scrap of surface, or not asked for
};

// The outer loop of a component is the boundary of the largest extent, where one that has the surface inside
// it counts for more and one that has it around it for less. `components`: by number.
ClassifiedLoops classify_loops(const std::vector<Loop>& loops,
                               const std::vector<SurfaceComponent>& components, const RimEvidence& evidence,
                               const BoundaryLoopOptions& options);

}  // namespace rimline
