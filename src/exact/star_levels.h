// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics of the circumradii in many overlapping stars.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/complex.h"
#include "rimline/run.h"
#include "rimline/unfilled.h"

namespace rimline::exact {

// How many radii of each star are below each of 32 limits, a byte each. A radius is in the surroundings of
// some twenty points, and how many are below the limits there is the sum of as many rows of bytes. So it pays
// to look at these first, and at radii only where they do not tell enough.
class StarLevels {
  static constexpr std::size_t limits = 32, block = 16;  // bytes that are added and compared at once
  using Block = std::uint8_t __attribute__((vector_size(block)));
  struct Row {
    Block low, high;
  };

 public:
  StarLevels(const Complex& complex, const Run& run);
  // The marked stars, whose triangles have changed; limits stay as they are.
  void renew(const Complex& complex, const std::vector<std::uint8_t>& changed, const Run& run);

  // What a radius of the level is at least, and less than.
  double least(int level) const { return least_[static_cast<std::size_t>(level)]; }
  double above(int level) const { return least_[static_cast<std::size_t>(level) + 1]; }

  // Of the stars of some vertices: triangles in several of them count several times.
  struct Sum {
    std::size_t count;
    Row below;  // wrong where the count is more than `most`
  };
  static constexpr std::size_t most = 254;
  Sum sum(std::span<const Index> vertices) const;
  // The levels of the radii at three ranks, from 0, below the count, which is at most `most`.
  static std::array<int, 3> levels_at(const Sum& sum, const std::array<std::size_t, 3>& ranks);

 private:
  template <class LevelOf>
  void count_star(const Complex& complex, Index vertex, const LevelOf& level_of);

  std::array<int, limits> starts_;          // of the levels above the first, as steps
  std::array<double, limits + 2> least_{};  // of each level, and what is more than all radii
  UnfilledVector<std::uint8_t> size_;       // of each star, or 255 where it is more
  UnfilledVector<Row> row_;
};

}  // namespace rimline::exact
