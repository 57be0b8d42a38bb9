// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/far_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/parallel.h"

namespace rimline {
namespace {

constexpr double out_of_proportion = 0x1p20;
constexpr std::size_t share_of_far = 100;  // at most one of so many is far

using Axis = double Point::*;
constexpr std::array<Axis, 3> axes = {&Point::x, &Point::y, &Point::z};

// Half the largest side, which does not overflow.
double half_extent(const PointBox& box) {
  double most = 0;
  for (const Axis axis : axes) most = std::max(most, 0.5 * box.high.*axis - 0.5 * box.low.*axis);
  return most;
}

// Whether the middle half of the points lies in two neighbouring parts of 1,024 along the longest side:
// nearly no cloud has it, so that the others need no sorting.
bool is_crowded(Points points, const PointBox& box, const Run& run) {
  constexpr std::size_t bins = 1024, block = 65536;
  const double scale = (bins - 1) / half_extent(box);
  if (!std::isfinite(scale)) return false;
  const std::size_t blocks = (points.size() + block - 1) / block;
  std::vector<std::array<std::uint32_t, bins>> counts(blocks);
  for (const Axis axis : axes) {
    parallel_tasks(blocks, Stage::Arrange, run, [&](std::size_t k) {
      counts[k].fill(0);
      for (std::size_t i = k * block; i < std::min(points.size(), (k + 1) * block); ++i) {
        if (!is_finite(points[i])) continue;
        ++counts[k][static_cast<std::size_t>((0.5 * points[i].*axis - 0.5 * box.low.*axis) * scale)];
      }
    });
    run.check_cancel();
    std::array<std::size_t, bins> sums{};
    std::size_t all = 0, most = 0;
    for (const auto& part : counts) {
      for (std::size_t b = 0; b < bins; ++b) sums[b] += part[b], all += part[b];
    }
    for (std::size_t b = 0; b + 1 < bins; ++b) most = std::max(most, sums[b] + sums[b + 1]);
    if (2 * most < all) return false;
  }
  return true;
}

// From the first to the third quarter of each coordinate.
PointBox quarters_of(Points points) {
  PointBox box;
  std::vector<double> values;
  for (const Axis axis : axes) {
    values.clear();
    for (const Point& p : points) {
      if (is_finite(p)) values.push_back(p.*axis);
    }
    const auto at = [&](std::size_t k) {
      std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
      return values[k];
    };
    box.low.*axis = at(values.size() / 4);
    box.high.*axis = at(values.size() - 1 - values.size() / 4);
  }
  return box;
}

}  // namespace

std::optional<PointBox> box_without_far_points(Points points, const PointBox& all, const Run& run) {
  const double half = half_extent(all);
  if (!(half > 0) || !is_crowded(points, all, run)) return std::nullopt;
  const PointBox quarters = quarters_of(points);
  const double reach = 2 * out_of_proportion * half_extent(quarters);
  if (!(reach > 0) || !(reach < 2 * half)) return std::nullopt;
  const Point around{reach, reach, reach};
  const PointBox box{quarters.low - around, quarters.high + around};
  const auto far = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [&](const Point& p) { return is_finite(p) && !box.has(p); }));
  if (far == 0 || far > std::max<std::size_t>(1, points.size() / share_of_far)) return std::nullopt;
  return box;
}

}  // namespace rimline
