// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics of the circumradii in many overlapping stars.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rimline/neighbours.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"
#include "surface/triangle_set.h"

namespace rimline {

// How many radii of each star are below each of 32 limits, a byte each. A radius is in the surroundings of
// some twenty points, and how many are below the limits there is the sum of as many rows of bytes. So it pays
// to look at these first, and at radii only where they do not tell enough.
class StarLevels {
 public:
  StarLevels(const TriangleSet& set, const Run& run);
  // The marked stars, whose triangles have changed; limits stay as they are.
  void renew(const TriangleSet& set, const std::vector<std::uint8_t>& changed, const Run& run);

  // What a radius of the level is at least, and less than.
  double least(int level) const { return least_[static_cast<std::size_t>(level)]; }
  double above(int level) const { return least_[static_cast<std::size_t>(level) + 1]; }

  // Of the radii in the stars of a vertex and of its nearest neighbours, where triangles in several of them
  // count several times: the levels at ranks_among() their number. Unknown where that is 0, or more than a
  // byte counts.
  struct Around {
    std::uint8_t lower = 0, typical = 0, upper = 0;
    bool known = false;
  };
  static std::array<std::size_t, 3> ranks_among(std::size_t count) {
    return {count / 4, 5 * count / 8, 3 * count / 4};  // [layout] quartiles, and a usual size
  }
  // Of vertices that follow each other, from the first on, with so many neighbours each.
  void look(const Neighbours& neighbours, int near, Index first, std::span<Around> found) const;

 private:
  static constexpr std::size_t limits = 32, block = 16;  // bytes that are added and compared at once [layout]
  using Block = std::uint8_t __attribute__((vector_size(block)));
  struct Row {
    Block low, high;
  };
  template <class LevelOf>
  static Row count_star(std::span<const Index> star, const LevelOf& level_of);
  static std::uint8_t level_at(const Row& below, std::size_t rank);

  std::array<int, limits> starts_;          // of the levels above the first, as steps
  std::array<double, limits + 2> least_{};  // of each level, and what is more than all radii
  UnfilledVector<std::uint8_t> size_;       // of each star, or 255 where it is more
  UnfilledVector<Row> row_;
};

}  // namespace rimline
