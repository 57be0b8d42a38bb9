// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/kd_tree.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <bit>
#include <cstdint>

#include "base/parallel.h"
#include "base/select.h"
#include "points/morton.h"

namespace rimline {
namespace {

constexpr std::size_t least_parallel = 8192;  // points in a task: long enough to hide its cost
constexpr std::size_t most_in_cell = 16384;   // points that fit a second-level cache, 32 bytes each

PointBox box_of(Points points) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, points.size(), least_parallel), PointBox{},
      [&](const auto& range, PointBox box) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) box.add(points[i]);
        return box;
      },
      [](PointBox a, const PointBox& b) {
        a.add(b);
        return a;
      });
}

// Whether points come along a curve, as from arrange(): but for rounding, no code is less than one before it.
bool follows(const MortonCurve& curve, Points points) {
  constexpr std::size_t stride = 64;
  if (!curve.has_cells()) return false;
  std::size_t steps = 0, back = 0;
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < points.size(); i += stride, ++steps) {
    const std::uint64_t code = curve.code(points[i]);
    back += code < last;
    last = code;
  }
  return 64 * back <= steps;
}

// The first point in the upper one of the two halves of the least cell that holds all from `begin` to `end`;
// one of these where there is none.
std::uint32_t halve(const MortonCurve& curve, Points points, std::uint32_t begin, std::uint32_t end) {
  const std::uint64_t first = curve.code(points[begin]), last = curve.code(points[end - 1]);
  if (first >= last) return begin;
  const std::uint64_t upper = last & ~((std::uint64_t{1} << (std::bit_width(first ^ last) - 1)) - 1);
  const auto middle = std::partition_point(points.begin() + begin, points.begin() + end,
                                           [&](const Point& p) { return curve.code(p) < upper; });
  return static_cast<std::uint32_t>(middle - points.begin());
}

Bounds join(const Bounds& a, const Bounds& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace

// Gives the node of a place in the cell's heap (1 is the cell's own node, v has the children 2 v and 2 v + 1)
// its box, and splits its points.
void KdTree::split(const Cell& cell, Item* items, std::size_t heap) {
  Node& node = nodes_[heap == 1 ? cell.node : cell.first_below + heap - 2];
  const std::size_t count = node.end - node.begin;
  double low[3], high[3];
  std::copy_n(items[0].coordinate, 3, low);
  std::copy_n(items[0].coordinate, 3, high);
  for (std::size_t i = 1; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], items[i].coordinate[axis]);
      high[axis] = std::max(high[axis], items[i].coordinate[axis]);
    }
  }
  node.bounds = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  const int below = cell.depth + 1 - static_cast<int>(std::bit_width(heap));  // levels
  if (below == 0) {
    node.child = 0;
    leaves_[cell.first_leaf + heap - (std::size_t{1} << cell.depth)] =
        static_cast<std::uint32_t>(&node - nodes_.data());
    return;
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  const std::size_t half = count / 2;
  select(items, items + half, items + count,
         [longest](const Item& item) { return item.coordinate[longest]; });
  node.child = static_cast<std::uint32_t>(cell.first_below + 2 * heap - 2);
  nodes_[node.child].begin = node.begin;
  nodes_[node.child].end = nodes_[node.child + 1].begin = node.begin + static_cast<std::uint32_t>(half);
  nodes_[node.child + 1].end = node.end;
  if (count < least_parallel) {
    split(cell, items, 2 * heap);
    split(cell, items + half, 2 * heap + 1);
  } else {
    tbb::parallel_invoke([&] { split(cell, items, 2 * heap); },
                         [&] { split(cell, items + half, 2 * heap + 1); });
  }
}

void KdTree::build(const Cell& cell, Points points, UnfilledVector<Item>& items) {
  const std::size_t first = nodes_[cell.node].begin;
  items.resize(nodes_[cell.node].end - first);
  const tbb::blocked_range<std::size_t> all(0, items.size(), least_parallel);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Point& p = points[first + i];
      items[i] = {{p.x, p.y, p.z}, static_cast<Index>(first + i)};
    }
  });
  split(cell, items.data(), 1);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      x[first + i] = items[i].coordinate[0], y[first + i] = items[i].coordinate[1];
      z[first + i] = items[i].coordinate[2], id[first + i] = items[i].id;
    }
  });
}

// Halves cells of the curve that the points come along, if they do, down to `most_in_cell` points.
void KdTree::split_along_curve(Points points) {
  const MortonCurve curve(box_of(points));
  if (!follows(curve, points)) return;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::uint32_t begin = nodes_[n].begin, end = nodes_[n].end;
    if (end - begin <= most_in_cell) continue;
    const std::uint32_t middle = halve(curve, points, begin, end);
    if (middle == begin || middle == end) continue;
    nodes_[n].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, begin, middle, 0});
    nodes_.push_back({{}, middle, end, 0});
  }
}

// A subtree that is still to be split, with the range of nodes and leaves reserved for it.
std::vector<KdTree::Cell> KdTree::make_cells(int leaf) {
  std::vector<Cell> cells;
  std::size_t nodes = nodes_.size(), leaves = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!nodes_[n].is_leaf()) continue;
    Cell cell{n, nodes, 0, 0};
    while (nodes_[n].end - nodes_[n].begin > static_cast<std::size_t>(leaf) << cell.depth) ++cell.depth;
    nodes += (std::size_t{2} << cell.depth) - 2;
    cells.push_back(cell);
  }
  std::sort(cells.begin(), cells.end(),
            [this](const Cell& a, const Cell& b) { return nodes_[a.node].begin < nodes_[b.node].begin; });
  for (Cell& cell : cells) {
    cell.first_leaf = leaves;
    leaves += std::size_t{1} << cell.depth;
  }
  nodes_.resize(nodes);
  leaves_.resize(leaves);
  return cells;
}

KdTree::KdTree(Points points, int leaf, const Run& run)
    : x(points.size()), y(points.size()), z(points.size()), id(points.size()) {
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(size()), 0});
  Arena(run).execute([&] {
    if (size() > most_in_cell) split_along_curve(points);
    const std::size_t upper = nodes_.size();
    const std::vector<Cell> cells = make_cells(leaf);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size()), [&](const auto& range) {
      UnfilledVector<Item> items;
      for (std::size_t c = range.begin(); c < range.end(); ++c) build(cells[c], points, items);
    });
    for (std::size_t n = upper; n-- > 0;) {  // children come after their parents
      const std::uint32_t child = nodes_[n].child;
      if (child > 0) nodes_[n].bounds = join(nodes_[child].bounds, nodes_[child + 1].bounds);
    }
  });
}

}  // namespace rimline
