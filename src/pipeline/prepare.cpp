// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/prepare.h"

#include "base/domain_traits.h"
#include "pipeline/given_loops.h"
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

}  // namespace

void check_input(Points input, const Options& options, const Given& given) {
  check_corners(input, options.map);
  if (!given.normals.empty() && given.normals.size() != input.size()) {
    throw Error(ErrorCode::BadOption, "there must be one normal per point, or none");
  }
  check_given_loops(given.loops, input.size());
}

PreparedPoints prepare(Points input, const Options& options, const Run& run, StageClock& clock) {
  const int k = most_neighbours(options);
  clock.enter(Stage::Arrange);
  Arrangement arrangement = arrange(input, run);
  clock.enter(Stage::Neighbours);
  Neighbours neighbours = find_neighbours(arrangement.points, k, run);
  if (leave_out_stray(arrangement, neighbours, run)) {
    neighbours = find_neighbours(arrangement.points, k, run);
  }
  std::vector<double> spacing = local_spacing(arrangement.points, neighbours, run);
  const SpacingSummary summary = summarize_spacing(spacing, run);
  return {input, std::move(arrangement), std::move(neighbours), std::move(spacing), summary};
}

}  // namespace rimline::pipeline
