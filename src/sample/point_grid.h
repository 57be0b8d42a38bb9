// SPDX-License-Identifier: GPL-3.0-or-later
// Points in cubic cells found by hashing: grows by one point at a time, for queries about the size of a cell.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rimline/points.h"

namespace rimline {

class PointGrid {
 public:
  // `cell` in units of length; `expected` points make the table large enough to be fast.
  PointGrid(double cell, std::size_t expected)
      : scale_(1 / cell), head_(std::bit_ceil(std::max<std::size_t>(expected, 64)), none) {
    points_.reserve(expected);
    next_.reserve(expected);
  }

  void insert(const Point& p) {
    const std::size_t bucket = bucket_of(cell_of(p.x), cell_of(p.y), cell_of(p.z));
    next_.push_back(head_[bucket]);
    head_[bucket] = static_cast<Index>(points_.size());
    points_.push_back(p);
  }

  // Calls visit(id) for every point in a cell that the ball about `centre` touches, and perhaps for others;
  // an id may come twice.
  template <class Visit>
  void near(const Point& centre, double radius, const Visit& visit) const {
    const std::int64_t x0 = cell_of(centre.x - radius), x1 = cell_of(centre.x + radius);
    const std::int64_t y0 = cell_of(centre.y - radius), y1 = cell_of(centre.y + radius);
    const std::int64_t z0 = cell_of(centre.z - radius), z1 = cell_of(centre.z + radius);
    for (std::int64_t z = z0; z <= z1; ++z) {
      for (std::int64_t y = y0; y <= y1; ++y) {
        for (std::int64_t x = x0; x <= x1; ++x) {
          for (Index i = head_[bucket_of(x, y, z)]; i != none; i = next_[i]) visit(i);
        }
      }
    }
  }

  const std::vector<Point>& points() const { return points_; }
  std::vector<Point> take_points() { return std::move(points_); }

 private:
  std::int64_t cell_of(double x) const { return static_cast<std::int64_t>(std::floor(x * scale_)); }
  // Neighbours along x share cache lines; two cells in one bucket cost a few distances, no more.
  std::size_t bucket_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto key = static_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15u +
                     static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fu;
    return key & (head_.size() - 1);
  }

  double scale_;
  std::vector<Index> head_, next_;
  std::vector<Point> points_;
};

}  // namespace rimline
