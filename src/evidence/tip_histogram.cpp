// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/tip_histogram.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

// 1 at the vertices of rims.
std::vector<std::uint8_t> rim_vertices(const TriangleSet& set, const Run& run) {
  std::vector<std::uint8_t> marked(set.vertices(), 0);
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) {
    const Triangle& x = set.triangle(t);
    for (int k = 0; k < 3; ++k) {
      if (set.across(t, k) != none) continue;
      for (const Index v : {x[k], x[next_in(k, 3)]})
        std::atomic_ref(marked[v]).store(1, std::memory_order_relaxed);
    }
  });
  return marked;
}

}  // namespace

double tip_of(const TriangleSet& set, Index triangle) {
  const Triangle& x = set.triangle(triangle);
  const Points p = set.points();
  std::array<double, 3> side{norm(p[x[1]] - p[x[0]]), norm(p[x[2]] - p[x[1]]), norm(p[x[0]] - p[x[2]])};
  std::sort(side.begin(), side.end());
  const auto [a, b, c] = side;
  // Of small differences, Kahan 1986: twice the arc tangent of the root of (s - a)(s - b) / s(s - c).
  const double up = std::max(0.0, (c - (b - a)) * (c + (b - a)));
  const double down = std::max(0.0, (a + (b + c)) * (a + (b - c)));
  return 2 * std::atan2(std::sqrt(up), std::sqrt(down));
}

int TipHistogram::interval_of(double tip) {
  constexpr double least = std::numbers::pi / 3, width = (std::numbers::pi - least) / intervals;
  return std::clamp(static_cast<int>((tip - least) / width), 0, intervals - 1);
}

TipHistogram::TipHistogram(const TriangleSet& set, const Run& run) {
  const std::vector<std::uint8_t> on_rim = rim_vertices(set, run);
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) {
    const Triangle& x = set.triangle(t);
    if (on_rim[x[0]] || on_rim[x[1]] || on_rim[x[2]]) return;
    std::atomic_ref(wider_[interval_of(tip_of(set, t))]).fetch_add(1, std::memory_order_relaxed);
  });
  for (int i = intervals - 1; i > 0; --i) wider_[i - 1] += wider_[i];
}

double TipHistogram::log_tail(double tip) const {
  return std::log((wider_[0] + 1.0) / (wider_[interval_of(tip)] + 1.0));
}

}  // namespace rimline
