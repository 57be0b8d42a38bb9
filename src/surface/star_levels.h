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

// The number of radii of each star below each of 32 limits, one byte each. A radius is in the surroundings of
// some twenty points, and the counts of a point's surroundings are the sum of as many rows of bytes. So these
// counts are tested first, and radii only where the counts do not suffice.
class StarLevels {
 public:
  StarLevels(const TriangleSet& set, const Run& run);
  // Updates the marked stars, whose triangles have changed; the limits stay.
  void renew(const TriangleSet& set, const std::vector<std::uint8_t>& changed, const Run& run);

  // Bounds of the radii of a level: at least, and below.
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
