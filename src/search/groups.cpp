// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/groups.h"

#include <algorithm>
#include <tuple>

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
    groups.all[g].push_back(i);
  }
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(-candidates.log_ratio[a], a) < std::tuple(-candidates.log_ratio[b], b);
  };
  for (CandidateGroup& group : groups.all) {
    std::sort(group.begin(), group.end(), before);
    for (std::uint32_t k = 0; k < group.size(); ++k) groups.place[group[k]] = k;
  }
  std::sort(groups.all.begin(), groups.all.end(),
            [&](const CandidateGroup& a, const CandidateGroup& b) { return before(a[0], b[0]); });
  return groups;
}

}  // namespace rimline
