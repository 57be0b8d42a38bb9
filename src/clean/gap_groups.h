// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of points that gaps part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel.h"
#include "base/union_find.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The groups that the `count` nearest of each point make, where is_joined(i, j) tells whether two of them
// hang together. Edges within a block of ids are joined by its own thread, which touches no other block's
// sets; those between blocks, few as ids follow a curve, afterwards. `left_out`: points (1) that join
// nothing.
template <class IsJoined>
UnionFind gap_groups(std::size_t size, const Neighbours& neighbours, int count,
                     const std::vector<char>& left_out, const IsJoined& is_joined, const Run& run) {
  constexpr std::size_t block = 16384;  // [speed]
  struct Edge {
    Index a, b;
  };
  UnionFind groups(size);
  count = std::min(count, neighbours.k);
  const std::size_t blocks = (size + block - 1) / block;
  std::vector<std::vector<Edge>> between(blocks);
  parallel_tasks(blocks, Stage::Neighbours, run.without_progress(), [&](std::size_t b) {
    const auto begin = static_cast<Index>(b * block);
    const auto end = static_cast<Index>(std::min(size, (b + 1) * block));
    for (Index i = begin; i < end; ++i) {
      if (left_out[i]) continue;
      for (const Index j : neighbours.of(i, count)) {
        if (left_out[j]) continue;
        if (j < begin || j >= end) {
          between[b].push_back({i, j});
        } else if (groups.find(i) != groups.find(j) && is_joined(i, j)) {
          groups.join(i, j);
        }
      }
    }
  });
  run.check_cancel();
  for (const std::vector<Edge>& edges : between) {
    for (const auto [i, j] : edges) {
      if (groups.find(i) != groups.find(j) && is_joined(i, j)) groups.join(i, j);
    }
  }
  return groups;
}

}  // namespace rimline
