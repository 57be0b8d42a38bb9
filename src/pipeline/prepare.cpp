// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/prepare.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "base/domain_traits.h"
#include "base/quantile.h"
#include "pipeline/given_loops.h"
#include "rimline/clean.h"
#include "rimline/measure.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void check_corners(Points input, const ParameterizeOptions& map) {
  if (map.corners[0] == none) return;
  if (traits(map.domain).outline != Outline::Box) {
    throw Error(ErrorCode::BadOption, "corners are for the domains square and rectangle alone");
  }
  for (const Index id : map.corners) {
    if (id >= 0 && id < static_cast<Index>(input.size())) continue;
    throw Error(ErrorCode::BadOption, "a corner is no point of the input", {id});
  }
}

// Points with their neighbours and spacings.
struct Sampled {
  Arrangement arrangement;
  Neighbours neighbours;
  std::vector<double> spacing;
};

Sampled with_neighbours(Arrangement arrangement, int k, const Run& run) {
  Neighbours neighbours = find_neighbours(arrangement.points, k, run);
  std::vector<double> spacing = local_spacing(arrangement.points, neighbours, run);
  return {std::move(arrangement), std::move(neighbours), std::move(spacing)};
}

// Without points on given loops: they are wanted.
StrayPoints without_given(StrayPoints stray, const Arrangement& arrangement, const std::vector<Loop>& loops) {
  std::vector<Index> given;
  for (const Loop& loop : loops) given.insert(given.end(), loop.points.begin(), loop.points.end());
  std::ranges::sort(given);
  for (auto* list : {&stray.off_surface, &stray.on_line, &stray.apart})
    std::erase_if(*list, [&](Index i) { return std::ranges::binary_search(given, arrangement.ids[i]); });
  return stray;
}

// The arrangement of the points that are left, as if there had been no others: places and numbers that depend
// on the whole, as the origin, do not tell of what was removed.
Arrangement arrange_again(Points input, Arrangement arrangement, const Run& run) {
  std::vector<Point> left(input.size(), Point{nan, nan, nan});
  for (const Index id : arrangement.ids) left[id] = input[id];
  Arrangement again = arrange(left, run);
  again.not_finite = std::move(arrangement.not_finite);
  again.duplicates.insert(again.duplicates.end(), arrangement.duplicates.begin(),
                          arrangement.duplicates.end());
  std::ranges::sort(again.duplicates);
  again.stray = std::move(arrangement.stray);
  return again;
}

// The step of each axis, and of the terraces that were found.
StepSummary summarize_steps(const Sampled& sampled, const std::optional<Terraces>& terraces) {
  StepSummary steps;
  if (sampled.spacing.empty()) return steps;
  const double usual = median(sampled.spacing);
  const auto quantum = [&](double Point::*axis) {
    const auto levels = find_levels(sampled.arrangement.points, axis, usual);
    return levels ? levels->quantum : 0.0;
  };
  steps.x = quantum(&Point::x);
  steps.y = quantum(&Point::y);
  steps.z = quantum(&Point::z);
  if (!terraces) return steps;
  constexpr std::array names{"x", "y", "z"};
  steps.removed = terraces->levels.quantum;
  steps.removed_along = terraces->centre ? "ray" : names[static_cast<std::size_t>(terraces->axis)];
  return steps;
}

// The places from which the points may have been seen, in the coordinates of the arrangement: the one given,
// and the origin of the input, where depth cameras have it.
std::vector<Point> centres_of(const Arrangement& arrangement, const Given& given) {
  std::vector<Point> centres{Point{} - arrangement.origin};
  if (given.viewpoint) centres.insert(centres.begin(), *given.viewpoint - arrangement.origin);
  return centres;
}

// The input with the points in use moved off their terraces; empty where there are none after all.
std::vector<Point> smoothed_input(Points input, const Sampled& sampled, const Terraces& terraces,
                                  const Run& run) {
  std::vector<Point> smoothed(input.begin(), input.end());
  const std::vector<Point> moved =
      without_terraces(sampled.arrangement.points, terraces, sampled.spacing, run);
  if (moved.empty()) return {};
  for (std::size_t i = 0; i < moved.size(); ++i)
    smoothed[sampled.arrangement.ids[i]] = moved[i] + sampled.arrangement.origin;
  return smoothed;
}

// Removes stray points until none is found, and finds the neighbours of the others. Some can be found only
// after those beside them were removed.
Sampled without_stray_points(Sampled sampled, Points input, int k, const std::vector<Loop>& given,
                             const Run& run) {
  constexpr int most_rounds = 6;
  for (int round = 0; round < most_rounds; ++round) {
    const auto& [arrangement, neighbours, spacing] = sampled;
    const StrayPoints stray =
        without_given(find_stray_points(arrangement.points, neighbours, spacing, run), arrangement, given);
    if (stray.empty()) break;
    leave_out(sampled.arrangement, all_of(stray));
    sampled = with_neighbours(arrange_again(input, std::move(sampled.arrangement), run), k, run);
  }
  return sampled;
}

}  // namespace

void check_input(Points input, const Options& options, const Given& given) {
  check_corners(input, options.map);
  if (!given.normals.empty() && given.normals.size() != input.size()) {
    throw Error(ErrorCode::BadOption, "there must be one normal per point, or none");
  }
  if (!given.raster.empty() && given.raster.size() != input.size()) {
    throw Error(ErrorCode::BadOption, "there must be one cell of the raster per point, or none");
  }
  check_given_loops(given.loops, input.size());
}

PreparedPoints prepare(Points input, const Options& options, const Given& given, const Run& run,
                       StageClock& clock) {
  const int k = most_neighbours(options);
  clock.enter(Stage::Arrange);
  Arrangement arrangement = arrange(input, run);
  clock.enter(Stage::Neighbours);
  Sampled sampled = with_neighbours(std::move(arrangement), k, run);
  std::vector<Point> smoothed;
  std::optional<Terraces> terraces;
  if (counts(UsedBy::Default, options)) {
    terraces = find_terraces(sampled.arrangement.points, sampled.neighbours, sampled.spacing,
                             centres_of(sampled.arrangement, given), run);
  }
  if (terraces) smoothed = smoothed_input(input, sampled, *terraces, run);
  if (smoothed.empty()) terraces.reset();
  const StepSummary steps = summarize_steps(sampled, terraces);
  if (terraces)
    sampled = with_neighbours(arrange_again(smoothed, std::move(sampled.arrangement), run), k, run);
  const Points used = terraces ? Points(smoothed) : input;
  if (leave_out_stray(sampled.arrangement, sampled.neighbours, run))
    sampled = with_neighbours(arrange_again(used, std::move(sampled.arrangement), run), k, run);
  if (counts(UsedBy::Default, options))
    sampled = without_stray_points(std::move(sampled), used, k, given.loops, run);
  const SpacingSummary summary = summarize_spacing(sampled.spacing, run);
  return {input,
          std::move(sampled.arrangement),
          std::move(sampled.neighbours),
          std::move(sampled.spacing),
          summary,
          steps};
}

std::vector<Point> PreparedPoints::places() const {
  std::vector<Point> places;
  for (const Index id : ids()) places.push_back(input[id] - arrangement.origin);
  return places;
}

}  // namespace rimline::pipeline
