// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input.h"

#include <algorithm>

#include "rimline/measure.h"

namespace rimline::pipeline {
namespace {

void check_corners(const Work& work) {
  const std::array<Index, 4>& corners = work.options.map.corners;
  if (corners[0] == none) return;
  if (work.options.map.domain != Domain::Square && work.options.map.domain != Domain::Rectangle) {
    throw Error(ErrorCode::BadOption, "corners are for the domains square and rectangle alone");
  }
  for (const Index id : corners) {
    if (id >= 0 && id < static_cast<Index>(work.input.size())) continue;
    throw Error(ErrorCode::BadOption, "a corner is no point of the input", {id});
  }
}

}  // namespace

void check_input(const Work& work) {
  check_options(work.options);
  if (work.is_paper() && work.options.map.domain != Domain::Disc) {
    throw Error(ErrorCode::BadOption,
                "the paper's presets map to the disc alone; take the preset default for others");
  }
  if (work.is_paper() && work.options.mesh.holes.fill) {
    throw Error(ErrorCode::BadOption,
                "the paper's presets fill every hole through the map; --holes is of the preset default");
  }
  check_corners(work);
  if (!work.given.normals.empty() && work.given.normals.size() != work.input.size()) {
    throw Error(ErrorCode::BadOption, "there must be one normal per point, or none");
  }
  for (const Loop& loop : work.given.loops) {
    for (const Index id : loop.points) {
      if (id < 0 || id >= static_cast<Index>(work.input.size())) {
        throw Error(ErrorCode::BadOption, "a given loop names a point that the input does not have", {id});
      }
    }
  }
}

void prepare(Work& work) {
  const int k = most_neighbours(work.options);
  Arrangement& arrangement = work.arrangement;
  work.clock.enter(Stage::Arrange);
  arrangement = arrange(work.input, work.run);
  work.clock.enter(Stage::Neighbours);
  work.neighbours = find_neighbours(arrangement.points, k, work.run);
  if (leave_out_stray(arrangement, work.neighbours, work.run)) {
    work.neighbours = find_neighbours(arrangement.points, k, work.run);
  }
  work.spacing = local_spacing(arrangement.points, work.neighbours, work.run);
  work.report.points = {work.input.size(), arrangement.points.size(), arrangement.not_finite.size(),
                        arrangement.duplicates.size(), arrangement.stray.size()};
  work.report.spacing = summarize_spacing(work.spacing, work.run);
}

}  // namespace rimline::pipeline
