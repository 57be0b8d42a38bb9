// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimline {

void count_sectors(std::span<const UV> image, int sectors, std::vector<int>& counts) {
  counts.assign(sectors, 0);
  for (const UV& p : image) {
    double turn = std::atan2(p.v, p.u) / (2 * std::numbers::pi);  // (-1/2, 1/2]
    if (turn < 0) turn += 1;
    // A tiny negative angle rounds to a whole turn, which is no sector of its own.
    ++counts[std::min(sectors - 1, static_cast<int>(turn * sectors))];
  }
}

double pearson_statistic(std::span<const int> counts) {
  double total = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double statistic = 0;
  for (const int count : counts) statistic += (count - expected) * (count - expected) / expected;
  return statistic;
}

}  // namespace rimline
