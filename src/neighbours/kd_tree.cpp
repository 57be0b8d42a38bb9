// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/kd_tree.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include "parallel.h"

namespace rimline {
namespace {

constexpr std::size_t least_parallel = 8192;  // points in a task: long enough to hide its cost

}  // namespace

void KdTree::split(UnfilledVector<Item>& items, std::size_t node) {
  const std::size_t first = begin(node), last = end(node);
  double low[3], high[3];
  std::copy_n(items[first].coordinate, 3, low);
  std::copy_n(items[first].coordinate, 3, high);
  for (std::size_t i = first + 1; i < last; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], items[i].coordinate[axis]);
      high[axis] = std::max(high[axis], items[i].coordinate[axis]);
    }
  }
  bounds_[node] = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  if (is_leaf(node)) return;
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  std::nth_element(
      items.begin() + first, items.begin() + begin(2 * node + 1), items.begin() + last,
      [longest](const Item& a, const Item& b) { return a.coordinate[longest] < b.coordinate[longest]; });
  if (last - first < least_parallel) {
    split(items, 2 * node);
    split(items, 2 * node + 1);
  } else {
    tbb::parallel_invoke([&] { split(items, 2 * node); }, [&] { split(items, 2 * node + 1); });
  }
}

KdTree::KdTree(Points points, int leaf, const Run& run)
    : x(points.size()), y(points.size()), z(points.size()), id(points.size()) {
  while (size() > static_cast<std::size_t>(leaf) << depth_) ++depth_;
  bounds_.resize(2 * leaf_count());
  for (std::size_t i = 0; i <= leaf_count(); ++i) first_.push_back(size() * i >> depth_);
  UnfilledVector<Item> items(size());
  tbb::task_arena(thread_count(run)).execute([&] {
    const tbb::blocked_range<std::size_t> all(0, size(), least_parallel);
    tbb::parallel_for(all, [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        items[i] = {{points[i].x, points[i].y, points[i].z}, static_cast<Index>(i)};
      }
    });
    split(items, 1);
    tbb::parallel_for(all, [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        x[i] = items[i].coordinate[0], y[i] = items[i].coordinate[1], z[i] = items[i].coordinate[2];
        id[i] = items[i].id;
      }
    });
  });
}

}  // namespace rimline
