// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/share_out.h"

#include <algorithm>

namespace rimline {
namespace {

constexpr Index several = -2;

// The place of a point among the ascending ids of a patch, or none where it is not among them.
Index place_in(const std::vector<Index>& ids, Index point) {
  const auto at = std::lower_bound(ids.begin(), ids.end(), point);
  return at == ids.end() || *at != point ? none : static_cast<Index>(at - ids.begin());
}

}  // namespace

std::vector<std::vector<Triangle>> share_out(const std::vector<Triangle>& triangles, std::size_t points,
                                             const std::vector<PatchInput>& patches) {
  std::vector<Index> patch_of(points, none), local(points, none);
  for (Index p = 0; p < static_cast<Index>(patches.size()); ++p) {
    for (Index i = 0; i < static_cast<Index>(patches[p].points.size()); ++i) {
      const Index v = patches[p].points[i];
      patch_of[v] = patch_of[v] == none ? p : several;
      local[v] = i;
    }
  }
  std::vector<std::vector<Triangle>> parts(patches.size());
  for (const Triangle& t : triangles) {
    const Index p = std::max({patch_of[t[0]], patch_of[t[1]], patch_of[t[2]]});
    if (p < 0) continue;
    Triangle own = t;
    for (Index& v : own) {
      v = patch_of[v] == p ? local[v] : patch_of[v] == several ? place_in(patches[p].points, v) : none;
    }
    if (std::ranges::find(own, none) == own.end()) parts[p].push_back(own);
  }
  return parts;
}

}  // namespace rimline
