// SPDX-License-Identifier: GPL-3.0-or-later
// A k-d tree.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"

namespace rimline {

// An axis-parallel box, both ends included.
struct Bounds {
  Point low, high;
};

// The gaps below are the coordinate differences that squared_distance() takes, summed in the same order. As
// rounding is monotone, they never exceed the computed distance to a point inside: pruning loses nothing.
inline double gap(double low, double high, double other_low, double other_high) {
  return std::max({0.0, low - other_high, other_low - high});
}
inline double squared_gap(const Bounds& a, const Bounds& b) {
  const Point d{gap(a.low.x, a.high.x, b.low.x, b.high.x), gap(a.low.y, a.high.y, b.low.y, b.high.y),
                gap(a.low.z, a.high.z, b.low.z, b.high.z)};
  return dot(d, d);
}

// Levels halve the points of the level above at the median of the box's longest side, so that leaves hold
// leaf / 2 to `leaf` points, whatever their distribution. Where the points come along a Morton curve, as from
// arrange(), the upper levels are the cells of this curve, whose points are together already, and the rest is
// built cell by cell in the cache. The tree's shape changes nothing of what is found in it.
class KdTree {
 public:
  struct Node {
    Bounds bounds;
    std::uint32_t begin, end;  // places of its points in x, y, z, id
    std::uint32_t child;       // the first of two that follow each other, or 0: a leaf
    bool is_leaf() const { return child == 0; }
  };

  KdTree(Points points, int leaf, const Run& run);

  static constexpr std::size_t root = 0;
  std::size_t size() const { return id.size(); }
  std::size_t leaf_count() const { return leaves_.size(); }
  const Node& node(std::size_t node) const { return nodes_[node]; }
  std::size_t leaf_node(std::size_t leaf) const { return leaves_[leaf]; }
  Point point(std::size_t place) const { return {x[place], y[place], z[place]}; }

  // The points in the order of the leaves, a coordinate an array; id: their ids in the input.
  UnfilledVector<double> x, y, z;
  UnfilledVector<Index> id;

 private:
  struct Item {
    double coordinate[3];
    Index id;
  };
  // A node whose subtree is balanced: 2^depth leaves. Its points are those at its places in the input, too.
  struct Cell {
    std::size_t node, first_below, first_leaf;
    int depth;
  };
  void split_along_curve(Points points);
  std::vector<Cell> make_cells(int leaf);
  void build(const Cell& cell, Points points, UnfilledVector<Item>& items);
  void split(const Cell& cell, Item* items, std::size_t heap);

  UnfilledVector<Node> nodes_;
  UnfilledVector<std::uint32_t> leaves_;  // their nodes, in the order of places
};

}  // namespace rimline
