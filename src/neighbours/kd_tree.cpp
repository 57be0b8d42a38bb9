// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/kd_tree.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include <functional>

#include "parallel.h"

namespace rimline {
namespace {

constexpr std::size_t least_parallel = 8192;  // points in a task: long enough to hide its cost

double middle_of(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

}  // namespace

// Moves those below the pivot (or not above it) to the front. What a comparison says is added, not branched
// on: it would be mistaken half of the time.
template <class Compare>
KdTree::Item* KdTree::partition(Item* first, Item* last, int axis, double pivot, const Compare& is_low) {
  Item* high = first;
  for (Item* i = first; i < last; ++i) {
    const Item item = *i;
    *i = *high;
    *high = item;
    high += is_low(item.coordinate[axis], pivot);
  }
  return high;
}

// The same as std::nth_element by one coordinate.
void KdTree::select(Item* first, Item* nth, Item* last, int axis) {
  constexpr std::ptrdiff_t few = 16;
  while (last - first > few) {
    const auto sample = [&](int part) { return first[part * (last - first - 1) / 8].coordinate[axis]; };
    const double pivot =
        middle_of(middle_of(sample(0), sample(1), sample(2)), middle_of(sample(3), sample(4), sample(5)),
                  middle_of(sample(6), sample(7), sample(8)));
    Item* high = partition(first, last, axis, pivot, std::less<>());
    if (high == first) {  // the pivot is the least: those that equal it need no order
      high = partition(first, last, axis, pivot, std::less_equal<>());
      if (nth < high) return;
    }
    nth < high ? last = high : first = high;
  }
  std::nth_element(first, nth, last, [axis](const Item& a, const Item& b) {
    return a.coordinate[axis] < b.coordinate[axis];
  });
}

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
  select(items.data() + first, items.data() + begin(2 * node + 1), items.data() + last, longest);
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
