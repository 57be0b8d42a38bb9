// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/triangle_tree.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>

#include "base/parallel.h"
#include "base/prefault.h"
#include "base/select.h"

namespace rimline {

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
  std::vector<Item> items;
  resize_together(boxes_, triangles.size(), run);
  resize_together(order_, triangles.size(), run);
  resize_together(nodes_, static_cast<std::size_t>(count_nodes(count)), run);
  resize_together(items, triangles.size(), run);
  Arena arena(run);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<Index>(0, count, 4096), [&](const auto& range) {
      for (Index t = range.begin(); t < range.end(); ++t) {
        const Box& box = boxes_[t] = box_of(points, triangles[t]);
        items[t].triangle = t;
        for (int i = 0; i < 3; ++i) items[t].place[i] = box.low[i] + box.high[i];
      }
    });
    run.check_cancel();
    build(items, 0, 0, count);
  });
  run.check_cancel();
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
void TriangleTree::build(std::vector<Item>& items, Index id, Index begin, Index end) {
  constexpr Index alone = 4096;  // triangles that are not worth a second thread
  Node& node = nodes_[id];
  node.begin = begin;
  node.end = end;
  if (end - begin <= leaf_size) {
    node.box = boxes_[items[begin].triangle];
    for (Index i = begin; i < end; ++i) {
      order_[i] = items[i].triangle;
      node.box.include(boxes_[items[i].triangle]);
    }
    return;
  }
  std::array<double, 3> low = items[begin].place, high = low;
  for (Index i = begin + 1; i < end; ++i) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], items[i].place[k]);
      high[k] = std::max(high[k], items[i].place[k]);
    }
  }
  int side = 0;
  for (int k = 1; k < 3; ++k) {
    if (high[k] - low[k] > high[side] - low[side]) side = k;
  }
  const Index middle = begin + (end - begin) / 2;
  select(&items[begin], &items[begin] + (middle - begin), &items[begin] + (end - begin),
         [side](const Item& item) { return item.place[side]; });
  node.left = id + 1;
  node.right = node.left + node_count_.at(middle - begin);
  const auto build_left = [&] { build(items, node.left, begin, middle); };
  const auto build_right = [&] { build(items, node.right, middle, end); };
  if (end - begin > alone) {
    tbb::parallel_invoke(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
  node.box = nodes_[node.left].box;
  node.box.include(nodes_[node.right].box);
}

}  // namespace rimline
