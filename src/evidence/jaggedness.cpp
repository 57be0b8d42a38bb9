// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/jaggedness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/model.h"
#include "base/prefault.h"

namespace rimline {
namespace {

double turning(Points p, Index a, Index b, Index c) {
  const Point in = p[b] - p[a], out = p[c] - p[b];
  return std::min(model::jagged_most, std::atan2(norm(cross(in, out)), dot(in, out)));
}

}  // namespace

std::vector<double> jaggedness(Points points, const std::vector<Index>& loop) {
  const std::size_t n = loop.size(), side = std::min(model::jagged_reach, (n - 1) / 2), all = 2 * side + 1;
  std::vector<double> sum(n + all, 0);  // of the turnings from corner -side on
  for (std::size_t i = 0; i + 1 < sum.size(); ++i) {
    const std::size_t at = i + n - side;
    sum[i + 1] = sum[i] + turning(points, loop[(at + n - 1) % n], loop[at % n], loop[(at + 1) % n]);
  }
  const double once_round = 2 * std::numbers::pi / static_cast<double>(n);
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double mean = (sum[i + all] - sum[i]) / static_cast<double>(all) - once_round;
    result[i] = std::clamp((mean - model::jagged_none) / (model::jagged_full - model::jagged_none), 0.0, 1.0);
  }
  return result;
}

std::vector<double> evenness(Points points, const std::vector<std::vector<Index>>& loops, const Run& run) {
  std::vector<double> result;
  resize_together(result, points.size(), run);
  for (const auto& loop : loops) {
    if (loop.size() < model::jagged_least_rim) continue;
    const std::vector<double> jagged = jaggedness(points, loop);
    for (std::size_t i = 0; i < loop.size(); ++i) result[loop[i]] = std::max(result[loop[i]], 1 - jagged[i]);
  }
  return result;
}

}  // namespace rimline
