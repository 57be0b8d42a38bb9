// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of candidates that influence each other.
#pragma once

#include <cstdint>
#include <vector>

#include "search/candidates.h"

namespace rimline {

using CandidateGroup = std::vector<std::uint32_t>;  // positions in Candidates::triangles, the largest first

struct CandidateGroups {
  std::vector<CandidateGroup> all;
  std::vector<std::uint32_t> place;  // of each candidate triangle in its group
};

// Groups of candidates that are connected by shared vertices: no other candidate influences them. Groups, and
// the candidates in each, are sorted by size, which does not change when the cloud is turned. The search
// processes them in this order; the random stream of a group depends on the group alone.
CandidateGroups group_candidates(const Candidates& candidates);

}  // namespace rimline
