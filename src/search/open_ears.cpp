// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/open_ears.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/fitness.h"

namespace rimline {
namespace {

// The differing triangles that hang together with the first one, which are marked as seen.
std::vector<Index> differing_from(const TriangleSet& set, const Selection& before, const Selection& after,
                                  Index first, std::vector<std::uint8_t>& seen) {
  std::vector<Index> found(1, first);
  seen[first] = 1;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const Index v : set.triangle(found[k])) {
      for (const Index t : set.star(v)) {
        if (seen[t] || before[t] == after[t]) continue;
        seen[t] = 1;
        found.push_back(t);
      }
    }
  }
  return found;
}

std::vector<Index> vertices_of(const TriangleSet& set, const std::vector<Index>& triangles) {
  std::vector<Index> vertices;
  for (const Index t : triangles)
    vertices.insert(vertices.end(), set.triangle(t).begin(), set.triangle(t).end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Of the corners, sides and insides of some triangles: the Euler number of those that are selected, and the
// points where fans meet.
struct Topology {
  int euler = 0;
  double pinches = 0;
  bool operator==(const Topology&) const = default;
};

Topology topology_at(const TriangleSet& set, const Selection& selection, const std::vector<Index>& triangles,
                     const std::vector<Index>& vertices, const FanCorners& corners) {
  Topology found;
  for (std::size_t slot = 0; slot < vertices.size(); ++slot) {
    const auto& star = set.star(vertices[slot]);
    found.euler += std::any_of(star.begin(), star.end(), [&](Index t) { return selection[t] != 0; });
    found.pinches += corners.turns(slot, selection).pinches;
  }
  for (const Index t : triangles) {
    found.euler += selection[t];
    for (int k = 0; k < 3; ++k) {
      const Index beside = set.across(t, k);
      const bool is_twice =
          beside != none && std::find(triangles.begin(), triangles.end(), beside) != triangles.end();
      if (is_twice && beside < t) continue;
      found.euler -= selection[t] || (beside != none && selection[beside]);
    }
  }
  return found;
}

bool is_ear(const TriangleSet& set, const Selection& before, const Selection& after,
            const std::vector<Index>& differing, const Run& run) {
  if (std::any_of(differing.begin(), differing.end(), [&](Index t) { return after[t] != 0; })) return false;
  const std::vector<Index> vertices = vertices_of(set, differing);
  const FanCorners corners(set, vertices, run);
  return topology_at(set, before, differing, vertices, corners) ==
         topology_at(set, after, differing, vertices, corners);
}

}  // namespace

Selection open_ears(const TriangleSet& set, const Selection& before, const Selection& after, std::size_t most,
                    const Run& run) {
  Selection result = before;
  std::vector<std::uint8_t> seen(set.size(), 0);
  for (Index first = 0; first < set.size(); ++first) {
    if (seen[first] || before[first] == after[first]) continue;
    const std::vector<Index> differing = differing_from(set, before, after, first, seen);
    if (differing.size() > most || !is_ear(set, before, after, differing, run)) continue;
    for (const Index t : differing) result[t] = 0;
  }
  return result;
}

}  // namespace rimline
