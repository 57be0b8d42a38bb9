// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/star_levels.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "parallel.h"

namespace rimline::exact {
namespace {

constexpr std::size_t block = 16;  // bytes that are compared at once
using Block = std::uint8_t __attribute__((vector_size(block)));
constexpr std::size_t most_triangles = 255 * block;  // a lane counts no further
constexpr int last_level = 255;
constexpr int shift = 48;  // of the bits of a number, to leave sixteen steps an octave

// For numbers that are not negative the order of their bits is their own.
int step_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value + 0.0) >> shift);  // no negative zero
}

double first_of(int step) { return std::bit_cast<double>(static_cast<std::uint64_t>(step) << shift); }

// In the middle of things, so that levels reach far to both sides.
int middle_step(const Complex& complex) {
  constexpr Index most_asked = 1024;
  std::vector<int> steps;
  const Index stride = 1 + complex.size() / most_asked;
  for (Index t = 0; t < complex.size(); t += stride) steps.push_back(step_of(complex.radius(t)));
  if (steps.empty()) return last_level;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

StarLevels::StarLevels(const Complex& complex, const Run& run)
    : complex_(complex),
      lowest_(std::max(0, middle_step(complex) - last_level / 2)),
      start_(static_cast<std::size_t>(complex.vertices()) + 1, 0) {
  for (Index v = 0; v < complex.vertices(); ++v) {
    start_[v + 1] = start_[v] + static_cast<std::uint32_t>(complex.star(v).size());
  }
  level_.resize(start_.back() + block);  // whole blocks are read at the end, too
  parallel_for_each(complex.vertices(), Stage::Loops, run, [&](Index v) {
    std::uint8_t* level = level_.data() + start_[v];
    for (const Index t : complex.star(v)) {
      *level++ = static_cast<std::uint8_t>(std::clamp(step_of(complex.radius(t)) - lowest_, 0, last_level));
    }
  });
}

double StarLevels::least(int level) const { return level == 0 ? 0 : first_of(lowest_ + level); }

double StarLevels::above(int level) const {
  return level == last_level ? std::numeric_limits<double>::infinity() : first_of(lowest_ + level + 1);
}

std::size_t StarLevels::Search::take(std::span<const Index> vertices) {
  vertices_ = vertices;
  size_ = 0;
  for (const Index v : vertices) {
    const std::uint32_t first = levels_.start_[v], count = levels_.start_[v + 1] - first;
    if (level_.size() < size_ + count + 2 * block) level_.resize(2 * (size_ + count + 2 * block));
    for (std::uint32_t from = 0; from < count; from += block) {  // a star is hardly ever more than one
      std::memcpy(level_.data() + size_ + from, levels_.level_.data() + first + from, block);
    }
    size_ += count;
  }
  if (size_ > 0) std::memset(level_.data() + size_, last_level, block);  // fills the last block up
  return size_;
}

// How many are at a lower level than this one.
std::size_t StarLevels::Search::count_below(int level) const {
  if (size_ > most_triangles) {
    return static_cast<std::size_t>(std::count_if(level_.begin(), level_.begin() + size_,
                                                  [&](std::uint8_t other) { return other < level; }));
  }
  const Block limit = Block{} + static_cast<std::uint8_t>(level);
  Block sum{};
  for (std::size_t i = 0; i < size_; i += block) {
    Block values;
    std::memcpy(&values, level_.data() + i, block);
    sum -= reinterpret_cast<Block>(values < limit);  // -1 where true
  }
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < block; ++lane) count += sum[lane];
  return count;
}

// The level at a rank has at most `rank` below it, and the next one more. It is near the one found for the
// vertex before, with which most stars are shared.
std::array<int, 3> StarLevels::Search::levels_at(const std::array<std::size_t, 3>& ranks) {
  for (std::size_t r = 0; r < 3; ++r) {
    int& level = last_[r];
    if (count_below(level) > ranks[r]) {
      do --level;
      while (count_below(level) > ranks[r]);
    } else {
      while (level < last_level && count_below(level + 1) <= ranks[r]) ++level;
    }
  }
  return last_;
}

// Sorts the radii of one level.
void StarLevels::Search::gather(int level) {
  inside_.clear();
  std::size_t i = 0;
  for (const Index v : vertices_) {
    for (const Index t : levels_.complex_.star(v)) {
      if (level_[i++] == level) inside_.push_back(levels_.complex_.radius(t));
    }
  }
  std::sort(inside_.begin(), inside_.end());
}

std::array<double, 3> StarLevels::Search::radii_at(const std::array<std::size_t, 3>& ranks) {
  const std::array<int, 3> levels = levels_at(ranks);
  std::array<double, 3> result;
  for (std::size_t r = 0; r < 3; ++r) {
    if (r == 0 || levels[r] != levels[r - 1]) gather(levels[r]);
    result[r] = inside_[ranks[r] - count_below(levels[r])];
  }
  return result;
}

}  // namespace rimline::exact
