// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rimline {

// The value below which that share of the others lies, 0 to less than 1; changes their order. Of one value or
// more.
inline double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The value in the middle, by quantile().
inline double median(std::vector<double> values) { return quantile(values, 0.5); }

}  // namespace rimline
