// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include "mesh/orient.h"
#include "mesh/triangulation.h"

namespace rimline {
namespace {

// Triangles with their sides, found by edge.
struct Side {
  Index low, high, triangle;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles[t][c], triangles[t][next(c)]);
      sides.push_back({low, high, t});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

// Across side c, which leaves corner c; none at the rim.
std::vector<std::array<Index, 3>> across_sides(const std::vector<Triangle>& triangles) {
  const std::vector<Side> sides = sides_of(triangles);
  std::vector<std::array<Index, 3>> across(triangles.size(), {none, none, none});
  const auto put = [&](const Side& side, Index other) {
    const Triangle& t = triangles[side.triangle];
    for (int c = 0; c < 3; ++c) {
      if (std::minmax(t[c], t[next(c)]) == std::pair<const Index&, const Index&>(side.low, side.high))
        across[side.triangle][c] = other;
    }
  };
  for (std::size_t s = 1; s < sides.size(); ++s) {
    if (sides[s - 1].low != sides[s].low || sides[s - 1].high != sides[s].high) continue;
    put(sides[s - 1], sides[s].triangle);
    put(sides[s], sides[s - 1].triangle);
  }
  return across;
}

bool runs(const Triangle& t, Index from, Index to) {
  return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
}

}  // namespace

bool orient_alike(std::vector<Triangle>& triangles) {
  const std::vector<std::array<Index, 3>> across = across_sides(triangles);
  const std::vector<Triangle> given = triangles;
  std::vector<char> reached(triangles.size(), 0);
  bool agree = true;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (std::exchange(reached[first], 1)) continue;
    std::vector<Index> open{static_cast<Index>(first)};
    while (!open.empty()) {
      const Index t = open.back();
      open.pop_back();
      for (int c = 0; c < 3; ++c) {
        const Index other = across[t][c], a = given[t][c], b = given[t][next(c)];
        if (other == none) continue;
        const bool alike = runs(triangles[other], a, b) == runs(triangles[t], a, b);
        if (reached[other]) {
          agree = agree && !alike;
          continue;
        }
        reached[other] = 1;
        if (alike) std::swap(triangles[other][1], triangles[other][2]);
        open.push_back(other);
      }
    }
  }
  return agree;
}

void turn_loops_along(const std::vector<Triangle>& triangles, std::vector<Loop>& loops) {
  std::set<std::pair<Index, Index>> ahead;  // the first edge of each loop
  for (const Loop& loop : loops) ahead.emplace(loop.points[0], loop.points[1]);
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) ahead.erase({t[c], t[next(c)]});
  }
  for (Loop& loop : loops) {
    if (ahead.contains({loop.points[0], loop.points[1]}))
      std::reverse(loop.points.begin() + 1, loop.points.end());
  }
}

}  // namespace rimline
