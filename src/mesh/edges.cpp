// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edges.h"

#include <algorithm>
#include <cstdint>

#include "base/vec.h"

namespace rimline {

std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<std::uint64_t> keys;
  keys.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(t[c], t[next_in(c, 3)]);
      keys.push_back(static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high));
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Edge> edges;
  edges.reserve(keys.size() / 2 + 1);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i] == keys[i - 1]) {
      ++edges.back().triangles;
    } else {
      edges.push_back({static_cast<Index>(keys[i] >> 32), static_cast<Index>(keys[i] & 0xffffffff), 1});
    }
  }
  return edges;
}

}  // namespace rimline
