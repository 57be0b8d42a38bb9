// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of triangles, grouped by vertex. They tell a manifold without adjacency.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// The corners of all triangles, vertex by vertex.
struct Corners {
  struct Corner {
    Index next, previous;  // the triangle's other vertices
  };
  std::vector<Index> offsets;  // vertices + 1
  std::vector<Corner> corners;

  Corners(std::span<const Triangle> triangles, std::size_t points)
      : offsets(points + 1, 0), corners(3 * triangles.size()) {
    for (const Triangle& t : triangles) {
      for (const Index v : t) ++offsets[v + 1];
    }
    for (std::size_t v = 0; v < points; ++v) offsets[v + 1] += offsets[v];
    std::vector<Index> at(offsets.begin(), offsets.end() - 1);
    for (const auto& [a, b, c] : triangles) {
      corners[at[a]++] = {b, c};
      corners[at[b]++] = {c, a};
      corners[at[c]++] = {a, b};
    }
  }
  std::span<const Corner> of(Index vertex) const {
    return {corners.data() + offsets[vertex],
            static_cast<std::size_t>(offsets[vertex + 1] - offsets[vertex])};
  }
};

// The edges at one vertex, each with the corners that it bounds.
class Vertex {
 public:
  // Calls edge(other end, triangles) for each edge, ascending by its other end. Returns into how many fans
  // the triangles fall when they are joined across shared edges.
  template <class VisitEdge>
  std::size_t visit(std::span<const Corners::Corner> corners, const VisitEdge& edge) {
    sides_.clear();
    group_.resize(corners.size());
    for (std::size_t c = 0; c < corners.size(); ++c) {
      group_[c] = c;
      sides_.push_back({corners[c].next, c});
      sides_.push_back({corners[c].previous, c});
    }
    std::sort(sides_.begin(), sides_.end());
    std::size_t fans = corners.size();
    for (std::size_t i = 0, j = 0; i < sides_.size(); i = j) {
      for (j = i + 1; j < sides_.size() && sides_[j].first == sides_[i].first; ++j)
        fans -= join(sides_[i].second, sides_[j].second);
      edge(sides_[i].first, j - i);
    }
    return fans;
  }

 private:
  std::size_t find(std::size_t c) {
    while (group_[c] != c) c = group_[c] = group_[group_[c]];
    return c;
  }
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    group_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  std::vector<std::pair<Index, std::size_t>> sides_;  // other end, corner
  std::vector<std::size_t> group_;                    // of each corner
};

}  // namespace rimline
