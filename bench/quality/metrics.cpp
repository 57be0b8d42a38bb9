// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/metrics.h"

namespace rimline::bench {

F1 f1_of_shares(double precision, double recall) {
  const double sum = precision + recall;
  return {precision, recall, sum > 0 ? 2 * precision * recall / sum : 0};
}

F1 f1_of(std::size_t common, std::size_t found, std::size_t truth) {
  const auto share = [&](std::size_t of, std::size_t other) {
    return of > 0 ? static_cast<double>(common) / static_cast<double>(of) : (other == 0 ? 1.0 : 0.0);
  };
  return f1_of_shares(share(found, truth), share(truth, found));
}

}  // namespace rimline::bench
