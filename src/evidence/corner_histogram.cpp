// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/corner_histogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/vec.h"
#include "evidence/jaggedness.h"

namespace rimline {
namespace {

int interval(double value, double low, double high, int count) {
  return static_cast<int>(std::clamp((value - low) / (high - low) * count, 0.0, count - 1.0));
}

bool is_jagged(Points points, const std::vector<Index>& rim) {
  const std::vector<double> jagged = jaggedness(points, rim);
  return std::any_of(jagged.begin(), jagged.end(), [](double j) { return j > 0; });
}

}  // namespace

CornerHistogram::CornerHistogram(const TriangleSet& set, const LocalSizes& sizes,
                                 const Neighbours& neighbours, const std::vector<std::vector<Index>>& rims,
                                 const Selection& selected) {
  std::vector<std::uint8_t> on_rim(set.vertices(), 0), near(set.vertices(), 0);
  for (const auto& rim : rims) {
    for (const Index v : rim) on_rim[v] = 1;
  }
  std::vector<Index> triangles;
  for (const auto& rim : rims) {
    if (!is_jagged(set.points(), rim)) continue;
    for (const Index v : rim) {
      for (const Index w : neighbours.of(v)) {
        if (std::exchange(near[w], 1)) continue;
        for (const Index t : set.star(w)) {
          const Triangle& x = set.triangle(t);
          if (selected[t] && !on_rim[x[0]] && !on_rim[x[1]] && !on_rim[x[2]]) triangles.push_back(t);
        }
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  const Points p = set.points();
  for (const Index t : triangles) {
    const Triangle& x = set.triangle(t);
    const int r = interval(sizes.log_ratio(x), -3, 3, ratios);
    for (int i = 0; i < 3; ++i) {
      const double angle = angle_at(p[x[(i + 2) % 3]], p[x[i]], p[x[next_in(i, 3)]]);
      ++count_[interval(angle, 0, std::numbers::pi, angles)][r];
    }
  }
  for (int a = angles - 1; a >= 0; --a) {
    std::uint32_t row = 0;
    for (int r = ratios - 1; r >= 0; --r) {
      row += count_[a][r];
      count_[a][r] = row + (a + 1 < angles ? count_[a + 1][r] : 0);
    }
  }
}

CornerHistogram& CornerHistogram::operator+=(const CornerHistogram& other) {
  for (int a = 0; a < angles; ++a) {
    for (int r = 0; r < ratios; ++r) count_[a][r] += other.count_[a][r];
  }
  return *this;
}

double CornerHistogram::log_tail(double angle, double log_ratio) const {
  const std::uint32_t like =
      count_[interval(angle, 0, std::numbers::pi, angles)][interval(log_ratio, -3, 3, ratios)];
  return std::log((count_[0][0] + 1.0) / (like + 1.0));
}

}  // namespace rimline
