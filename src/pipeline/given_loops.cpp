// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/given_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "rimline/find_genetic_loop.h"

namespace rimline::pipeline {
namespace {

std::vector<Loop> in_arranged_ids(std::vector<Loop> loops, const PreparedPoints& prepared) {
  std::vector<Index> arranged(prepared.input.size(), none);
  const std::vector<Index>& ids = prepared.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) arranged[ids[i]] = static_cast<Index>(i);
  std::vector<Index> out;
  for (Loop& loop : loops) {
    for (Index& id : loop.points) {
      if (arranged[id] == none) out.push_back(id);
      id = arranged[id];
    }
  }
  if (out.empty()) return loops;
  std::sort(out.begin(), out.end());
  const std::string message =
      fmt::format("{} points of the given loops take no part (duplicate, not finite or stray)", out.size());
  throw Error(ErrorCode::BadOption, message, std::move(out));
}

}  // namespace

void check_given_loops(const std::vector<Loop>& loops, std::size_t point_count) {
  std::vector<Index> all;
  for (const Loop& loop : loops) {
    if (loop.points.size() < 3)
      throw Error(ErrorCode::BadOption, "a given loop has fewer than three points", loop.points);
    all.insert(all.end(), loop.points.begin(), loop.points.end());
  }
  std::sort(all.begin(), all.end());
  if (all.empty()) return;
  if (all.front() < 0 || all.back() >= static_cast<Index>(point_count)) {
    const Index id = all.front() < 0 ? all.front() : all.back();
    throw Error(ErrorCode::BadOption, "a given loop names a point that the input does not have", {id});
  }
  std::vector<Index> repeated;
  for (auto at = all.begin(); (at = std::adjacent_find(at, all.end())) != all.end(); ++at) {
    if (repeated.empty() || repeated.back() != *at) repeated.push_back(*at);
  }
  if (repeated.empty()) return;
  throw Error(ErrorCode::BadOption,
              "given loops repeat points or share them, but a boundary passes each of its points once; lead "
              "one pass over a neighbour of each",
              std::move(repeated));
}

std::vector<Loop> arrange_loops(std::vector<Loop> given, const PreparedPoints& prepared,
                                const BoundaryScores& scores, const LoopOptions& options) {
  std::vector<Loop> loops = in_arranged_ids(std::move(given), prepared);
  for (Loop& loop : loops) {
    loop.length = loop_length(prepared.points(), loop.points);
    loop.fitness = fitness(loop.points, scores, options);
    loop.probability = std::numeric_limits<double>::quiet_NaN();
  }
  return loops;
}

std::vector<PointLabel> label_boundary(std::vector<PointLabel> label, const std::vector<Loop>& loops) {
  for (PointLabel& l : label) {
    if (l == PointLabel::Boundary) l = PointLabel::Interior;
  }
  for (const Loop& loop : loops) {
    for (const Index id : loop.points) label[id] = PointLabel::Boundary;
  }
  return label;
}

}  // namespace rimline::pipeline
