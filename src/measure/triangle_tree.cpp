// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/triangle_tree.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

#include "parallel.h"

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

TriangleTree::TriangleTree(Points points, const std::vector<Triangle>& triangles, const Run& run) {
  if (triangles.empty()) return;
  const auto count = static_cast<Index>(triangles.size());
  boxes_.resize(triangles.size());
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.resize(count_nodes(count));
  tbb::task_arena arena(thread_count(run));
  arena.execute([&] {
    tbb::parallel_for(Index{0}, count, [&](Index t) { boxes_[t] = box_of(points, triangles[t]); });
    build(0, 0, count);
  });
}

// The halves of all trees of one depth have one of two sizes, so there are few to remember.
Index TriangleTree::count_nodes(Index triangles) {
  if (triangles <= leaf_size) return node_count_[triangles] = 1;
  const auto known = node_count_.find(triangles);
  if (known != node_count_.end()) return known->second;
  const Index half = triangles / 2;
  const Index count = 1 + count_nodes(half) + count_nodes(triangles - half);
  return node_count_[triangles] = count;
}

// As deep as the logarithm of the count: halved evenly. Nodes follow their parent, the left ones first; as
// their number is known, both halves may be built at once.
void TriangleTree::build(Index id, Index begin, Index end) {
  constexpr Index alone = 4096;  // triangles that are not worth a second thread
  Node& node = nodes_[id];
  node = {boxes_[order_[begin]], begin, end};
  for (Index i = begin + 1; i < end; ++i) node.box.include(boxes_[order_[i]]);
  if (end - begin <= leaf_size) return;
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
  node.left = id + 1;
  node.right = node.left + node_count_.at(middle - begin);
  const auto build_left = [&] { build(node.left, begin, middle); };
  const auto build_right = [&] { build(node.right, middle, end); };
  if (end - begin > alone) {
    tbb::parallel_invoke(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
}

}  // namespace rimline
