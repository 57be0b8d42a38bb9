// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace rimline {

void Box::include(const Box& other) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

bool Box::meets(const Box& other) const {
  return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
         other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
}

double Box::squared_distance(Point p) const {
  const std::array<double, 3> at{p.x, p.y, p.z};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double out = std::max({low[i] - at[i], at[i] - high[i], 0.0});
    sum += out * out;
  }
  return sum;
}

Box box_of(Points points, const Triangle& t) {
  const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

TriangleTree::TriangleTree(Points points, const std::vector<Triangle>& triangles) {
  boxes_.reserve(triangles.size());
  for (const Triangle& t : triangles) boxes_.push_back(box_of(points, t));
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(triangles.size());
  if (!triangles.empty()) build(0, static_cast<Index>(triangles.size()));
}

// As deep as the logarithm of the count: halved evenly.
Index TriangleTree::build(Index begin, Index end) {
  const auto id = static_cast<Index>(nodes_.size());
  Node node{boxes_[order_[begin]], begin, end};
  for (Index i = begin + 1; i < end; ++i) node.box.include(boxes_[order_[i]]);
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return id;
  int side = 0;
  for (int i = 1; i < 3; ++i) {
    if (node.box.high[i] - node.box.low[i] > node.box.high[side] - node.box.low[side]) side = i;
  }
  const Index middle = begin + (end - begin) / 2;
  const auto place = [&](Index t) { return boxes_[t].low[side] + boxes_[t].high[side]; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index s, Index t) {
                     const double a = place(s), b = place(t);
                     return a < b || (a == b && s < t);
                   });
  const Index left = build(begin, middle), right = build(middle, end);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

}  // namespace rimline
