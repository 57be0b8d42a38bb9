// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/groups.h"

#include "base/union_find.h"

namespace rimline {

CandidateGroups group_candidates(const Candidates& candidates) {
  UnionFind sets(candidates.vertices.size());
  for (const auto& s : candidates.slots) {
    sets.join(s[0], s[1]);
    sets.join(s[0], s[2]);
  }
  CandidateGroups groups;
  groups.place.resize(candidates.slots.size());
  std::vector<Index> group_of(candidates.vertices.size(), none);
  for (std::uint32_t i = 0; i < candidates.slots.size(); ++i) {
    Index& g = group_of[sets.find(candidates.slots[i][0])];
    if (g == none) {
      g = static_cast<Index>(groups.all.size());
      groups.all.emplace_back();
    }
    groups.place[i] = static_cast<std::uint32_t>(groups.all[g].size());
    groups.all[g].push_back(i);
  }
  return groups;
}

}  // namespace rimline
