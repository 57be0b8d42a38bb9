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

// Of the lanes. Pairs of neighbouring bytes are added in words first, so that nothing runs over.
std::size_t sum_of(const Block& lanes) {
  constexpr std::uint64_t even = 0x00ff00ff00ff00ff, ones = 0x0001000100010001;
  std::uint64_t half[2];
  std::memcpy(half, &lanes, block);
  const std::uint64_t pairs =
      (half[0] & even) + (half[0] >> 8 & even) + (half[1] & even) + (half[1] >> 8 & even);
  return pairs * ones >> 48;
}

}  // namespace

StarLevels::StarLevels(const Complex& complex, const Run& run)
    : lowest_(std::max(0, middle_step(complex) - last_level / 2)),
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
  return counts_below({level, level, level})[0];
}

// The same for three levels at once.
std::array<std::size_t, 3> StarLevels::Search::counts_below(const std::array<int, 3>& levels) const {
  std::array<std::size_t, 3> counts;
  if (size_ > most_triangles) {
    for (int r = 0; r < 3; ++r) {
      counts[r] = static_cast<std::size_t>(std::count_if(
          level_.begin(), level_.begin() + size_, [&](std::uint8_t other) { return other < levels[r]; }));
    }
    return counts;
  }
  const Block limit0 = Block{} + static_cast<std::uint8_t>(levels[0]);
  const Block limit1 = Block{} + static_cast<std::uint8_t>(levels[1]);
  const Block limit2 = Block{} + static_cast<std::uint8_t>(levels[2]);
  Block sum0{}, sum1{}, sum2{};
  for (std::size_t i = 0; i < size_; i += block) {
    Block values;
    std::memcpy(&values, level_.data() + i, block);
    sum0 -= reinterpret_cast<Block>(values < limit0);  // -1 where true
    sum1 -= reinterpret_cast<Block>(values < limit1);
    sum2 -= reinterpret_cast<Block>(values < limit2);
  }
  return {sum_of(sum0), sum_of(sum1), sum_of(sum2)};
}

// The level at a rank has at most `rank` below it, and the next one more. It is near the one found for the
// vertex before, with which most stars are shared.
std::array<int, 3> StarLevels::Search::levels_at(const std::array<std::size_t, 3>& ranks) {
  const auto too_many = counts_below(last_);
  for (int r = 0; r < 3; ++r) {
    if (too_many[r] <= ranks[r]) continue;
    do --last_[r];
    while (count_below(last_[r]) > ranks[r]);
  }
  for (;;) {
    const auto enough = counts_below({last_[0] + 1, last_[1] + 1, last_[2] + 1});
    bool moved = false;
    for (int r = 0; r < 3; ++r) {
      if (enough[r] > ranks[r] || last_[r] == last_level) continue;
      ++last_[r];
      moved = true;
    }
    if (!moved) return last_;
  }
}

}  // namespace rimline::exact
