// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles in a tree of boxes.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

struct Box {
  std::array<double, 3> low{}, high{};

  void include(const Box& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  // Without branches between the sides: which of them separates two boxes can not be predicted.
  bool meets(const Box& other) const {
    bool meets = true;
    for (int i = 0; i < 3; ++i) meets &= (low[i] <= other.high[i]) & (other.low[i] <= high[i]);
    return meets;
  }
  double squared_distance(Point p) const;
};

Box box_of(Points points, const Triangle& t);

// A complete binary tree, halved at the median along the longest side of the boxes' middles down to leaves of
// at most `leaf_size` triangles. Deterministic.
class TriangleTree {
 public:
  static constexpr Index leaf_size = 8;

  struct Node {
    Box box;
    Index begin = 0, end = 0;  // of order()
    Index left = none;         // its children are left and right; none for a leaf
    Index right = none;
    bool is_leaf() const { return left == none; }
  };

  TriangleTree(Points points, const std::vector<Triangle>& triangles, const Run& run);

  const std::vector<Node>& nodes() const { return nodes_; }   // the root first; empty without triangles
  const std::vector<Index>& order() const { return order_; }  // positions of triangles, leaf after leaf
  const Box& box(Index triangle) const { return boxes_[triangle]; }

 private:
  // A triangle while the tree is built: values side by side are compared faster than through ids.
  struct Item {
    std::array<double, 3> place;  // the middle of its box, twice
    Index triangle;
  };

  Index count_nodes(Index triangles);
  void build(std::vector<Item>& items, Index id, Index begin, Index end);

  std::map<Index, Index> node_count_;  // nodes of a tree, by its triangles
  std::vector<Box> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace rimline
