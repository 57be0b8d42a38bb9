// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/given_loops.h"

#include <fmt/format.h>

#include <algorithm>

#include "rimline/loops.h"

namespace rimline::pipeline {
namespace {

// From ids of the input to those of the arrangement.
void arrange_loops(const Work& work, std::vector<Loop>& loops) {
  std::vector<Index> arranged(work.input.size(), none);
  const std::vector<Index>& ids = work.arrangement.ids;
  for (std::size_t i = 0; i < ids.size(); ++i) arranged[ids[i]] = static_cast<Index>(i);
  std::vector<Index> out;
  for (Loop& loop : loops) {
    for (Index& id : loop.points) {
      if (arranged[id] == none) out.push_back(id);
      id = arranged[id];
    }
  }
  if (out.empty()) return;
  std::sort(out.begin(), out.end());
  const std::string message =
      fmt::format("{} points of the given loops take no part (duplicate, not finite or stray)", out.size());
  throw Error(ErrorCode::BadOption, message, std::move(out));
}

void label_points(Work& work) {
  if (work.label.empty()) return;
  for (PointLabel& label : work.label) {
    if (label == PointLabel::Boundary) label = PointLabel::Interior;
  }
  for (const Loop& loop : work.loops) {
    for (const Index id : loop.points) work.label[id] = PointLabel::Boundary;
  }
}

}  // namespace

void take_given_loops(Work& work) {
  std::vector<Loop> loops = work.given.loops;
  arrange_loops(work, loops);
  for (Loop& loop : loops) {
    loop.length = loop_length(work.arrangement.points, loop.points);
    loop.fitness = fitness(loop.points, work.scores, work.options.loops);
  }
  work.loops = std::move(loops);
  label_points(work);
}

void check_reached(const std::vector<Index>& left_out) {
  if (left_out.empty()) return;
  const std::string message = fmt::format(
      "{} interior points have no chain of neighbours to a given loop; allow_partial leaves them out",
      left_out.size());
  throw Error(ErrorCode::UnreachableInterior, message, left_out);
}

}  // namespace rimline::pipeline
