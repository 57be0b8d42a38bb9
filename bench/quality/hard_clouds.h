// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds that break things: pieces of surfaces, lines and lumps thrown together, then rounded, doubled, moved
// far away or made partly no numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/points.h"

namespace rimline::bench {

struct HardCloud {
  std::vector<Point> points;
  bool has_surface =
      false;  // some piece of at least thirty points is a surface; else a refusal is right, too
};

// The same for the same seed and number.
HardCloud hard_cloud(std::uint64_t seed, std::uint64_t number);

}  // namespace rimline::bench
