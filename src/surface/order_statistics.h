// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics of about a hundred values, called a million times.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace rimline {

// The values at three ascending ranks (from 0, below their number) of some values, none of them negative or
// NaN. Exact: the same as sorting, for any values.
std::array<double, 3> at_ranks(std::span<const double> values, const std::array<std::size_t, 3>& ranks);

}  // namespace rimline
