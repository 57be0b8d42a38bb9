// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates that influence each other.
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

// The candidates that are connected over shared vertices: no other influences them. Groups, and the
// candidates in each, come in the order of their sizes, which a turn of the cloud leaves as they are: the
// search goes through them in turn, and each group has a random stream by its number.
CandidateGroups group_candidates(const Candidates& candidates);

}  // namespace rimline
