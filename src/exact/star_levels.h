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

namespace rimline::exact {

// The radii of all stars in 256 levels, sixteen an octave, a byte each and star after star. A radius is in
// the surroundings of some twenty points, so it pays to look at bytes first, and at radii only where the
// levels do not tell enough.
class StarLevels {
 public:
  StarLevels(const Complex& complex, const Run& run);

  // What a radius of the level is at least, and less than.
  double least(int level) const;
  double above(int level) const;

  // Asks for ranks again and again; each thread has one of its own.
  class Search {
   public:
    explicit Search(const StarLevels& levels) : levels_(levels) {}

    // Takes the stars of all these vertices; triangles in several of them count several times. Returns the
    // number of triangles.
    std::size_t take(std::span<const Index> vertices);
    // The levels at three ascending ranks, from 0, below that number.
    std::array<int, 3> levels_at(const std::array<std::size_t, 3>& ranks);

   private:
    std::size_t count_below(int level) const;
    std::array<std::size_t, 3> counts_below(const std::array<int, 3>& levels) const;

    const StarLevels& levels_;
    std::size_t size_ = 0;
    std::vector<std::uint8_t> level_;         // of each triangle
    std::array<int, 3> last_{128, 128, 128};  // the levels found before, near which the next ones are sought
  };

 private:
  int lowest_ = 0;                    // the first level, as the bits of a number say it
  std::vector<std::uint32_t> start_;  // of each vertex's star in level_
  std::vector<std::uint8_t> level_;
};

}  // namespace rimline::exact
