// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/prepare.h"

#include <algorithm>
#include <utility>

#include "base/domain_traits.h"
#include "pipeline/given_loops.h"
#include "rimline/clean.h"
#include "rimline/measure.h"

namespace rimline::pipeline {
namespace {

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

// Without points on given loops: they are wanted.
StrayPoints without_given(StrayPoints stray, const Arrangement& arrangement, const std::vector<Loop>& loops) {
  std::vector<Index> given;
  for (const Loop& loop : loops) given.insert(given.end(), loop.points.begin(), loop.points.end());
  std::ranges::sort(given);
  for (auto* list : {&stray.off_surface, &stray.on_line, &stray.apart})
    std::erase_if(*list, [&](Index i) { return std::ranges::binary_search(given, arrangement.ids[i]); });
  return stray;
}

// Removes stray points until none is found, and finds the neighbours of the others. Some can be found only
// after those beside them were removed.
void leave_out_dirt(Arrangement& arrangement, Neighbours& neighbours, std::vector<double>& spacing, int k,
                    const std::vector<Loop>& given, const Run& run) {
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round) {
    const StrayPoints stray =
        without_given(find_stray_points(arrangement.points, neighbours, spacing, run), arrangement, given);
    if (stray.empty()) break;
    leave_out(arrangement, all_of(stray));
    neighbours = find_neighbours(arrangement.points, k, run);
    spacing = local_spacing(arrangement.points, neighbours, run);
  }
}

}  // namespace

void check_input(Points input, const Options& options, const Given& given) {
  check_corners(input, options.map);
  if (!given.normals.empty() && given.normals.size() != input.size()) {
    throw Error(ErrorCode::BadOption, "there must be one normal per point, or none");
  }
  check_given_loops(given.loops, input.size());
}

PreparedPoints prepare(Points input, const Options& options, const Given& given, const Run& run,
                       StageClock& clock) {
  const int k = most_neighbours(options);
  clock.enter(Stage::Arrange);
  Arrangement arrangement = arrange(input, run);
  clock.enter(Stage::Neighbours);
  Neighbours neighbours = find_neighbours(arrangement.points, k, run);
  if (leave_out_stray(arrangement, neighbours, run)) {
    neighbours = find_neighbours(arrangement.points, k, run);
  }
  std::vector<double> spacing = local_spacing(arrangement.points, neighbours, run);
  if (counts(UsedBy::Default, options)) leave_out_dirt(arrangement, neighbours, spacing, k, given.loops, run);
  const SpacingSummary summary = summarize_spacing(spacing, run);
  return {input, std::move(arrangement), std::move(neighbours), std::move(spacing), summary};
}

}  // namespace rimline::pipeline
