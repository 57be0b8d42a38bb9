// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/ranks.h"

#include <algorithm>
#include <bit>
#include <boost/container/small_vector.hpp>
#include <cstdint>

namespace rimline::exact {
namespace {

// Numbers that are not negative are ordered as their bits are.
std::uint64_t order(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }

constexpr int buckets = 64;  // of nearly equal ratio; a hundred values put one or two into each

}  // namespace

std::array<double, 3> at_ranks(std::span<const double> values, const std::array<std::size_t, 3>& ranks) {
  std::uint64_t least = ~std::uint64_t{0}, most = 0;
  for (const double value : values) {
    least = std::min(least, order(value));
    most = std::max(most, order(value));
  }
  const int width = static_cast<int>(std::bit_width(most - least));
  const int shift = std::max(0, width - static_cast<int>(std::bit_width(unsigned{buckets - 1})));
  const auto bucket = [&](double value) { return static_cast<std::size_t>((order(value) - least) >> shift); };
  std::array<std::uint32_t, buckets> count{};
  for (const double value : values) ++count[bucket(value)];
  std::array<double, 3> result;
  std::size_t at = 0, before = 0;  // a bucket, and the values in those before it
  boost::container::small_vector<double, 32> inside;
  std::size_t gathered = buckets;
  for (std::size_t i = 0; i < 3; ++i) {
    while (before + count[at] <= ranks[i]) before += count[at++];
    if (gathered != at) {
      gathered = at;
      inside.clear();
      for (const double value : values) {
        if (bucket(value) == at) inside.push_back(value);
      }
      std::sort(inside.begin(), inside.end());
    }
    result[i] = inside[ranks[i] - before];
  }
  return result;
}

}  // namespace rimline::exact
