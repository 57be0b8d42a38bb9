// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of a manifold mesh, checked edge by edge in the plainest way: an oracle for what the library
// makes.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rimline::test {

using Corners = std::array<int, 3>;
using Sides = std::map<std::pair<int, int>, std::vector<int>>;  // the triangles at each edge, a < b

inline Sides sides_of(const std::vector<Corners>& triangles) {
  Sides sides;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c)
      sides[std::minmax({triangles[t][c], triangles[t][(c + 1) % 3]})].push_back(static_cast<int>(t));
  }
  return sides;
}

// The rim of a mesh without regard to direction.
inline std::set<std::pair<int, int>> rim_of(const std::vector<Corners>& triangles) {
  std::set<std::pair<int, int>> rim;
  for (const auto& [side, at] : sides_of(triangles)) {
    if (at.size() == 1) rim.insert(side);
  }
  return rim;
}

// Vertices whose triangles do not hang together by edges at the vertex.
inline std::set<int> split_vertices(const std::vector<Corners>& triangles) {
  std::map<int, std::vector<int>> stars;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const int v : triangles[t]) stars[v].push_back(static_cast<int>(t));
  }
  const auto has = [&](int t, int v) { return std::ranges::count(triangles[t], v) > 0; };
  std::set<int> split;
  for (const auto& [v, star] : stars) {
    std::vector<int> fan{star.front()};
    for (std::size_t i = 0; i < fan.size(); ++i) {
      for (const int other : star) {
        if (std::ranges::count(fan, other) > 0) continue;
        for (const int w : triangles[fan[i]]) {
          if (w == v || !has(other, w)) continue;
          fan.push_back(other);
          break;
        }
      }
    }
    if (fan.size() < star.size()) split.insert(v);
  }
  return split;
}

// The triangles of those components that can be oriented: walking over edges, each is told to be turned or
// not, and none is told both.
inline std::vector<Corners> two_sided(const std::vector<Corners>& triangles) {
  const Sides sides = sides_of(triangles);
  const auto runs_along = [&](int t, int a, int b) {
    for (int c = 0; c < 3; ++c) {
      if (triangles[t][c] == a && triangles[t][(c + 1) % 3] == b) return true;
    }
    return false;
  };
  std::vector<int> turned(triangles.size(), -1);  // -1: not reached yet
  std::set<int> one_sided;
  for (int start = 0; start < static_cast<int>(triangles.size()); ++start) {
    if (turned[start] >= 0) continue;
    std::vector<int> component{start};
    turned[start] = 0;
    bool can_be = true;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const int t = component[i];
      for (int c = 0; c < 3; ++c) {
        const int a = triangles[t][c], b = triangles[t][(c + 1) % 3];
        for (const int other : sides.at(std::minmax({a, b}))) {
          if (other == t) continue;
          const int wanted = runs_along(other, a, b) ? 1 - turned[t] : turned[t];
          if (turned[other] < 0) {
            turned[other] = wanted;
            component.push_back(other);
          }
          can_be &= turned[other] == wanted;
        }
      }
    }
    if (!can_be) one_sided.insert(component.begin(), component.end());
  }
  std::vector<Corners> oriented;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (one_sided.count(t) == 0) oriented.push_back(triangles[t]);
  }
  return oriented;
}

// "", or the first rule that the triangles break. Orientation is asked for where `oriented` is set: a
// one-sided surface has none.
inline std::string broken_rule(const std::vector<Corners>& triangles, int vertices, bool oriented = true) {
  std::set<std::set<int>> seen;
  std::set<std::pair<int, int>> directed;
  for (const Corners& t : triangles) {
    const std::set<int> corners(t.begin(), t.end());
    if (*corners.begin() < 0 || *corners.rbegin() >= vertices) return "a corner is no vertex";
    if (corners.size() < 3) return "a corner is repeated";
    if (!seen.insert(corners).second) return "a triangle is there twice";
    for (int c = 0; c < 3 && oriented; ++c) {
      if (!directed.emplace(t[c], t[(c + 1) % 3]).second) return "two triangles run along an edge alike";
    }
  }
  for (const auto& [side, at] : sides_of(triangles)) {
    if (at.size() > 2) return "an edge has three triangles";
  }
  return split_vertices(triangles).empty() ? "" : "a vertex has two fans";
}

}  // namespace rimline::test
