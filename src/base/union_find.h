// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of ids, with their sizes.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "rimline/points.h"

namespace rimline {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  // The representative of the set of `id`. Halves the path.
  Index find(Index id) {
    while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
    return id;
  }
  // Returns whether the two were apart.
  bool join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    return true;
  }
  Index size_of(Index id) { return size_[find(id)]; }

 private:
  std::vector<Index> parent_;
  std::vector<Index> size_;
};

}  // namespace rimline
