// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates that influence each other.
#pragma once

#include <cstdint>
#include <vector>

#include "search/candidates.h"

namespace rimline {

using CandidateGroup = std::vector<std::uint32_t>;  // positions in Candidates::triangles, ascending

struct CandidateGroups {
  std::vector<CandidateGroup> all;
  std::vector<std::uint32_t> place;  // of each doubtful triangle in its group
};

// The candidates that are connected over shared vertices: no other influences them.
CandidateGroups group_candidates(const Candidates& candidates);

}  // namespace rimline
