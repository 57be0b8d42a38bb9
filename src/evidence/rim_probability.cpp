// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/rim_probability.h"

#include <algorithm>
#include <numbers>

#include "base/parallel.h"
#include "base/vec.h"
#include "evidence/empty_ball.h"
#include "evidence/probability.h"
#include "local/mean_direction.h"

namespace rimline {
namespace {

// The vector area of a rim over that of a disc whose radius is the largest spacing on it.
double isoperimetric_ratio(const std::vector<Index>& rim, const Samples& samples) {
  double largest = 0;
  Point area;
  const Point origin = samples.points[rim[0]];
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Point a = samples.points[rim[i]], b = samples.points[rim[next_in(i, rim.size())]];
    area = area + 0.5 * cross(a - origin, b - origin);
    largest = std::max(largest, samples.spacing[rim[i]]);
  }
  return norm(area) / (std::numbers::pi * largest * largest);
}

double mean_thickness(const std::vector<Index>& rim, const std::vector<Frame>& frames) {
  double thickness = 0;
  for (const Index id : rim) thickness += frames[id].thickness / static_cast<double>(rim.size());
  return thickness;
}

// The radii of the empty balls beyond the edges of a rim, but for those behind false ears.
std::vector<double> empty_balls(const std::vector<Index>& rim, const RimEvidence& e, const Run& run) {
  const auto is_behind = [&](Index v) { return !e.behind_false_ear.empty() && e.behind_false_ear[v]; };
  const auto look = [&](std::size_t i, std::vector<double>& found) {
    const Index a = rim[i], b = rim[next_in(i, rim.size())];
    if (is_behind(a) || is_behind(b)) return;
    const Index inner = e.set.apex(selected_triangle(e.set, e.selection, a, b), a, b);
    found.push_back(
        empty_ball_radius(e.samples.points, e.samples.neighbours, e.samples.spacing, a, b, inner));
  };
  constexpr std::size_t in_task = 256, few = 4 * in_task;  // edges [speed]
  std::vector<double> radii;
  if (rim.size() >= few) return parallel_gather<double>(rim.size(), Stage::Loops, run, look, in_task);
  for (std::size_t i = 0; i < rim.size(); ++i) look(i, radii);
  return radii;
}

}  // namespace

double mean_one_sided(const std::vector<Index>& rim, const Samples& samples) {
  double sum = 0;
  for (const Index id : rim) sum += norm(mean_direction(samples, id, model::side_neighbours));
  return sum / static_cast<double>(rim.size());
}

RimMeasures measure_rim(const std::vector<Index>& rim, const RimEvidence& e, const Run& run) {
  std::vector<double> radii = empty_balls(rim, e, run);
  if (radii.empty()) return {};
  std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
  const double thickness = mean_thickness(rim, e.samples.frames);
  // Under noise the space beyond a small opening is too uncertain to outweigh that its rim looks like a
  // crease.
  const double bend = e.sampling.noise.noise > 0
                          ? no_gap(isoperimetric_ratio(rim, e.samples)) * thickness_of_opening(rim.size())
                          : 0;
  return {radii[radii.size() / 2], std::max(0.0, thickness - bend), true};
}

double rim_probability(const std::vector<Index>& rim, const RimEvidence& e, const Run& run) {
  if (e.sampling.is_range_image)
    return range_image_loop_probability(rim.size(), mean_one_sided(rim, e.samples));
  const RimMeasures measures = measure_rim(rim, e, run);
  return measures.is_known ? loop_probability(rim.size(), measures.empty_ball, measures.thickness) : 0;
}

double boundary_probability(const std::vector<Index>& rim, const RimEvidence& e, const Run& run) {
  const double p = rim_probability(rim, e, run);
  return e.sampling.is_range_image ? p : p * no_gap(isoperimetric_ratio(rim, e.samples));
}

}  // namespace rimline
