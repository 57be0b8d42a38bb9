// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/order_statistics.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace rimline {
namespace {

// Buckets of values in the order of their bits, which is the order of nonnegative numbers: sixteen an octave,
// four octaves about a middle value; values beyond go to the end buckets.
constexpr int buckets = 64;  // [speed]
constexpr int shift = 48;    // [layout]

class Buckets {
 public:
  explicit Buckets(double middle) : first_(level(middle) - buckets / 2) {}

  std::int32_t of(double value) const { return std::clamp(level(value) - first_, 0, buckets - 1); }

 private:
  static std::int32_t level(double value) {
    return static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(value + 0.0) >> shift);  // no negative zero
  }

  std::int32_t first_;
};

// Few are left, in any order.
void insertion_sort(double* first, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    const double value = first[i];
    std::size_t at = i;
    for (; at > 0 && value < first[at - 1]; --at) first[at] = first[at - 1];
    first[at] = value;
  }
}

constexpr std::size_t most = 256;  // values that are looked at in buckets [speed]

// Copies the values of one bucket. Eight values are tested at a time: the highest bit of each zero byte of a
// word is set.
std::size_t take_bucket(std::span<const double> values, const std::array<std::uint8_t, most>& bucket,
                        std::size_t wanted, std::array<double, most>& inside) {
  constexpr std::uint64_t low = 0x7f7f7f7f7f7f7f7f, ones = 0x0101010101010101;  // [layout]
  std::size_t found = 0;
  for (std::size_t first = 0; first < values.size(); first += 8) {  // [layout]
    std::uint64_t word;
    std::memcpy(&word, bucket.data() + first, 8);  // [layout]
    word ^= wanted * ones;
    std::uint64_t zeros = ~(((word & low) + low) | word | low);
    for (; zeros != 0; zeros &= zeros - 1) {
      const std::size_t bit = static_cast<std::size_t>(std::countr_zero(zeros)) / 8;  // [layout]
      inside[found++] =
          values[first + (std::endian::native == std::endian::little ? bit : 7 - bit)];  // [layout]
    }
  }
  return found;
}

}  // namespace

std::array<double, 3> at_ranks(std::span<const double> values, const std::array<std::size_t, 3>& ranks) {
  if (values.size() > most) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return {sorted[ranks[0]], sorted[ranks[1]], sorted[ranks[2]]};
  }
  const Buckets by(values[0]);
  std::array<std::uint16_t, buckets> count{};
  std::array<std::uint8_t, most> bucket;
  for (std::size_t i = 0; i < values.size(); ++i) {
    bucket[i] = static_cast<std::uint8_t>(by.of(values[i]));
    ++count[bucket[i]];
  }
  for (std::size_t i = values.size(); i % 8 != 0; ++i) bucket[i] = buckets;  // none of these [layout]
  std::array<double, 3> result;
  std::array<double, most> inside;
  std::size_t at = 0, before = 0;  // a bucket, and the values in those before it
  std::size_t taken = buckets;
  for (std::size_t i = 0; i < 3; ++i) {
    while (before + count[at] <= ranks[i]) before += count[at++];
    if (taken != at) {
      taken = at;
      const std::size_t found = take_bucket(values, bucket, at, inside);
      if (found > 16) {  // [speed]
        std::sort(inside.begin(), inside.begin() + static_cast<std::ptrdiff_t>(found));
      } else {
        insertion_sort(inside.data(), found);
      }
    }
    result[i] = inside[ranks[i] - before];
  }
  return result;
}

}  // namespace rimline
