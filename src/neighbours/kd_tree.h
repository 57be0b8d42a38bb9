// SPDX-License-Identifier: GPL-3.0-or-later
// A balanced k-d tree whose shape is arithmetic: nothing is stored but boxes and points.
#pragma once

#include <algorithm>
#include <bit>
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

// Node 1 is the root, node v has the children 2 v and 2 v + 1. A level halves the points of the level above
// at the median of the box's longest side, so that leaves hold leaf / 2 to `leaf` points, whatever their
// distribution.
class KdTree {
 public:
  KdTree(Points points, int leaf, const Run& run);

  std::size_t size() const { return id.size(); }
  std::size_t leaf_count() const { return std::size_t{1} << depth_; }
  std::size_t leaf_node(std::size_t leaf) const { return leaf_count() + leaf; }
  bool is_leaf(std::size_t node) const { return node >= leaf_count(); }
  // The places of a node's points: [begin, end) of x, y, z, id.
  std::size_t begin(std::size_t node) const { return first_[leftmost_leaf(node, node)]; }
  std::size_t end(std::size_t node) const { return first_[leftmost_leaf(node, node + 1)]; }
  const Bounds& bounds(std::size_t node) const { return bounds_[node]; }
  Point point(std::size_t place) const { return {x[place], y[place], z[place]}; }

  // The points in the order of the leaves, a coordinate an array; id: their ids in the input.
  UnfilledVector<double> x, y, z;
  UnfilledVector<Index> id;

 private:
  struct Item {
    double coordinate[3];
    Index id;
  };
  // The leftmost leaf below `other`, which is on the level of `node`, or one behind its end.
  std::size_t leftmost_leaf(std::size_t node, std::size_t other) const {
    return (other << (depth_ + 1 - std::bit_width(node))) - leaf_count();
  }
  void split(UnfilledVector<Item>& items, std::size_t node);
  static void select(Item* first, Item* nth, Item* last, int axis);
  template <class Compare>
  static Item* partition(Item* first, Item* last, int axis, double pivot, const Compare& is_low);

  int depth_ = 0;
  std::vector<std::size_t> first_;  // place of each leaf's first point, and the number of points
  std::vector<Bounds> bounds_;      // of each node
};

}  // namespace rimline
