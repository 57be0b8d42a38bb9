// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/star_levels.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "base/parallel.h"

namespace rimline {
namespace {

constexpr int shift = 47;  // of the bits of a number, to leave 32 steps an octave [layout]

// For numbers that are not negative the order of their bits is their own.
int step_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value + 0.0) >> shift);  // no negative zero
}

double first_of(int step) { return std::bit_cast<double>(static_cast<std::uint64_t>(step) << shift); }

// The steps that part the radii into equally many, by a sample.
template <std::size_t count>
std::array<int, count> part(const TriangleSet& set) {
  constexpr Index most_asked = 4096;  // [speed]
  std::vector<int> steps;
  const Index stride = 1 + set.size() / most_asked;
  for (Index t = 0; t < set.size(); t += stride) steps.push_back(step_of(set.radius(t)));
  std::sort(steps.begin(), steps.end());
  std::array<int, count> starts{};
  for (std::size_t i = 0; i < count && !steps.empty(); ++i)
    starts[i] = steps[(i + 1) * steps.size() / (count + 1)];
  return starts;
}

// How many of the ascending starts a radius reaches.
template <std::size_t count>
class Levels {
 public:
  explicit Levels(const std::array<int, count>& starts) : starts_(starts), first_(starts[count / 2] - reach) {
    for (std::size_t i = 0; i < level_.size(); ++i) level_[i] = search(first_ + static_cast<int>(i));
  }

  std::uint8_t of(double radius) const {
    const int step = step_of(radius);
    const auto i = static_cast<std::size_t>(step - first_);  // a large number where that is negative
    return i < level_.size() ? level_[i] : search(step);
  }

 private:
  static constexpr int reach = 512;  // steps to each side of the middle: 16 octaves [speed]

  std::uint8_t search(int step) const {
    const auto above = std::upper_bound(starts_.begin(), starts_.end(), step);
    return static_cast<std::uint8_t>(above - starts_.begin());
  }

  std::array<int, count> starts_;
  int first_;
  std::array<std::uint8_t, 2 * reach> level_;
};

constexpr std::size_t most_counted = 254;  // triangles of several stars [layout]

std::uint8_t size_of(std::span<const Index> star) {
  return static_cast<std::uint8_t>(std::min<std::size_t>(star.size(), 255));  // [layout]
}

}  // namespace

// Of the triangles of a star, how many are below each limit.
template <class LevelOf>
StarLevels::Row StarLevels::count_star(std::span<const Index> star, const LevelOf& level_of) {
  constexpr Block first{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},  // [layout]
      second = first + block;                                                   // [layout]
  Row below{};
  for (const Index t : star) {
    const std::uint8_t level = level_of(t);
    below.low -= reinterpret_cast<Block>(level <= first);  // -1 where true
    below.high -= reinterpret_cast<Block>(level <= second);
  }
  return below;
}

// The level at a rank is the number of limits below which there are at most so many.
std::uint8_t StarLevels::level_at(const Row& below, std::size_t rank) {
  const auto most = static_cast<std::uint8_t>(rank);
  const Block reached =
      -reinterpret_cast<Block>(below.low <= most) - reinterpret_cast<Block>(below.high <= most);
  std::uint64_t half[2];
  std::memcpy(half, &reached, block);
  constexpr std::uint64_t ones = 0x0101010101010101;                   // [layout]
  return static_cast<std::uint8_t>((half[0] + half[1]) * ones >> 56);  // 32 at most [layout]
}

StarLevels::StarLevels(const TriangleSet& set, const Run& run) : starts_(part<limits>(set)) {
  for (std::size_t i = 0; i < limits; ++i) least_[i + 1] = first_of(starts_[i]);
  least_[limits + 1] = std::numeric_limits<double>::infinity();
  const Levels levels(starts_);
  UnfilledVector<std::uint8_t> level(set.size());  // of each triangle
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) { level[t] = levels.of(set.radius(t)); });
  size_.resize(set.vertices());
  row_.resize(set.vertices());
  parallel_for_each(set.vertices(), Stage::Loops, run, [&](Index v) {
    size_[v] = size_of(set.star(v));
    row_[v] = count_star(set.star(v), [&](Index t) { return level[t]; });
  });
}

void StarLevels::renew(const TriangleSet& set, const std::vector<std::uint8_t>& changed, const Run& run) {
  const Levels levels(starts_);
  parallel_for_each(set.vertices(), Stage::Loops, run, [&](Index v) {
    if (!changed[v]) return;
    size_[v] = size_of(set.star(v));
    row_[v] = count_star(set.star(v), [&](Index t) { return levels.of(set.radius(t)); });
  });
}

void StarLevels::look(const Neighbours& neighbours, int near, Index first, std::span<Around> found) const {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Index v = first + static_cast<Index>(i);
    std::size_t count = size_[v];
    Row below = row_[v];
    for (const Index w : neighbours.of(v, near)) {
      count += size_[w];
      below.low += row_[w].low;
      below.high += row_[w].high;
    }
    const auto ranks = ranks_among(count);
    found[i] = {level_at(below, ranks[0]), level_at(below, ranks[1]), level_at(below, ranks[2]),
                count > 0 && count <= most_counted};
  }
}

}  // namespace rimline
