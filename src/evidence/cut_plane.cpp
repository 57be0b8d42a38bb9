// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/model.h"

namespace rimline {
namespace {

// Less biased than the spacing of a point of the rim, whose neighbours are on one side.
double spacing_around(const Neighbours& neighbours, const std::vector<double>& spacing, Index point) {
  const auto near = neighbours.of(point, std::min(model::few_neighbours, neighbours.k));
  double sum = spacing[point];
  for (const Index v : near) sum += spacing[v];
  return sum / static_cast<double>(near.size() + 1);
}

}  // namespace

std::optional<CutPlane> CutPlane::find(Points points, const Neighbours& neighbours,
                                       const std::vector<double>& spacing, const std::vector<Frame>& frames,
                                       const std::vector<Index>& rim) {
  if (rim.size() < model::cut_least_rim) return {};
  const auto n = static_cast<double>(rim.size());
  CutPlane plane;
  Point behind;  // mean of their neighbours, which are all on one side
  for (const Index v : rim) {
    plane.at_ = plane.at_ + (1 / n) * points[v];
    const auto near = neighbours.of(v);
    for (const Index w : near) behind = behind + (1 / (n * static_cast<double>(near.size()))) * points[w];
  }
  plane.inwards_ = fit_frame(points, std::span(rim).subspan(1), rim[0]).normal;
  if (dot(behind - plane.at_, plane.inwards_) < 0) plane.inwards_ = -1 * plane.inwards_;
  std::vector<double> heights;
  double squared = 0, sine = 0;
  for (const Index v : rim) {
    sine += plane.sine(frames[v]) / n;
    heights.push_back(dot(points[v] - plane.at_, plane.inwards_) / spacing_around(neighbours, spacing, v));
    squared += heights.back() * heights.back() / n;
  }
  if (squared > model::cut_flat * model::cut_flat || sine < model::cut_upright) return {};
  const auto outermost = heights.begin() + static_cast<std::ptrdiff_t>(model::cut_outermost *
                                                                       static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), outermost, heights.end());
  plane.outermost_ = *outermost;
  return plane;
}

double CutPlane::sine(const Frame& frame) const {
  const double cosine = dot(frame.normal, inwards_);
  return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

double CutPlane::depth(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                       const std::vector<Frame>& frames, Index point) const {
  const double along = sine(frames[point]);
  if (along < model::cut_least_sine) return std::numeric_limits<double>::infinity();
  const double height = dot(points[point] - at_, inwards_) / spacing_around(neighbours, spacing, point);
  return (height - outermost_) / along;
}

}  // namespace rimline
