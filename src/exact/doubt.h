// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that the rim search may leave out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/complex.h"

namespace rimline::exact {

constexpr std::uint32_t certain = ~std::uint32_t{0};

// The doubtful triangles, and how they hang together.
struct Doubt {
  std::vector<Index> triangles;         // ascending
  std::vector<double> gain;             // of leaving each out, before corners are looked at
  std::vector<double> log_ratio, spread;
  std::vector<std::array<Index, 3>> beside;                   // the triangles across its edges, or none
  std::vector<std::array<std::uint32_t, 3>> doubtful_beside;  // of those the positions here, or `certain`
  std::vector<std::array<double, 3>> contrast;  // worth of a rim between it, left out, and each of them, kept
  std::vector<Index> vertices;                  // of these triangles, ascending
  std::vector<std::array<std::uint32_t, 3>> slots;  // position of each triangle's vertices in `vertices`
};

using Group = std::vector<std::uint32_t>;  // positions in Doubt::triangles, ascending

struct Groups {
  std::vector<Group> all;
  std::vector<std::uint32_t> place;  // of each doubtful triangle in its group
};

// Those that share a vertex, and what shares one with these.
Groups group(const Doubt& doubt);

}  // namespace rimline::exact
