// SPDX-License-Identifier: GPL-3.0-or-later
// A small random stream that gives the same numbers with every compiler and library.
#pragma once

#include <cstdint>
#include <utility>

namespace rimline {

// SplitMix64 (Steele, Lea, Flood 2014): one addition and three mixing steps a number.
class Random {
 public:
  // Streams with different `stream` numbers are independent for the same seed.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix(seed) + mix(stream + 0x632be59bd9b4e019)) {}

  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15); }
  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  // Uniform in [0, count), 1 <= count < 2^53.
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
  }
  // Fisher-Yates.
  template <class Container>
  void shuffle(Container& items) {
    for (std::uint64_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace rimline
