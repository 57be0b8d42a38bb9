// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/loops_of_mesh.h"

#include <map>
#include <utility>

namespace rimline {
namespace {

// The loops through each point.
std::vector<std::vector<Index>> loops_at(const std::vector<Loop>& loops, std::size_t points) {
  std::vector<std::vector<Index>> at(points);
  for (Index l = 0; l < static_cast<Index>(loops.size()); ++l) {
    for (const Index v : loops[l].points) at[v].push_back(l);
  }
  return at;
}

}  // namespace

std::vector<MatchedRim> match_rims(std::vector<std::vector<Index>> rims, const std::vector<Loop>& loops,
                                   std::size_t points) {
  const std::vector<std::vector<Index>> at = loops_at(loops, points);
  struct Most {
    std::size_t shared = 0, rim = 0;
  };
  std::vector<Most> most(loops.size());
  std::vector<MatchedRim> matched(rims.size());
  for (std::size_t r = 0; r < rims.size(); ++r) {
    std::map<Index, std::size_t> shared;
    std::size_t on_loops = 0;
    for (const Index v : rims[r]) {
      on_loops += !at[v].empty();
      for (const Index l : at[v]) ++shared[l];
    }
    std::size_t best = 0;
    for (const auto& [loop, count] : shared) {
      if (count > most[loop].shared) most[loop] = {count, r};
      if (count <= best) continue;
      best = count;
      matched[r].loop = loop;
    }
    matched[r].is_open = 2 * on_loops >= rims[r].size();
    matched[r].points = std::move(rims[r]);
  }
  for (const Most& m : most) {
    if (m.shared > 0) matched[m.rim].is_open = true;
  }
  return matched;
}

}  // namespace rimline
