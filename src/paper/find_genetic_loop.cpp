// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/find_genetic_loop.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "paper/closed_paths.h"
#include "paper/genetic.h"
#include "paper/order.h"

namespace rimline {
namespace {

[[noreturn]] void throw_no_path(const BoundaryScores& scores, const ClosedPaths& paths) {
  std::vector<Index> ids;
  for (Index i = 0; i < static_cast<Index>(scores.candidate.size()); ++i) {
    if (scores.candidate[i]) ids.push_back(i);
  }
  const std::string bound = paths.bound_hit ? " within the bound on the work (max_path_steps)" : "";
  const std::string message =
      ids.empty() ? "no closed loop: no point is a boundary candidate, so the surface may be closed"
                  : fmt::format("no closed loop: none of {} boundary candidates starts a closed path{}",
                                paths.starts, bound);
  throw Error(ErrorCode::NoClosedLoop, message, std::move(ids));
}

}  // namespace

GeneticLoop find_genetic_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run) {
  const ClosedPaths paths = find_closed_paths(neighbours, scores, options, run);
  if (paths.best.empty()) throw_no_path(scores, paths);
  const Evolution evolution = evolve(paths.best, scores, options, run);

  GeneticLoop result;
  result.search.starts = paths.starts;
  result.search.closed_paths = paths.closed;
  result.search.distinct_paths = paths.distinct;
  result.search.steps = paths.steps;
  result.search.bound_hit = paths.bound_hit;
  result.search.history = evolution.history;
  // Crossover can break a path: the fittest chromosome that still contains a cycle wins.
  for (const ClosedPath& chromosome : evolution.fittest) {
    result.loop.points = order_loop(points, neighbours, options.path_k, scores, chromosome.ids);
    if (!result.loop.points.empty()) {
      result.winner = chromosome.ids;
      break;
    }
    ++result.search.winner_rank;
  }
  if (result.loop.points.empty()) throw_no_path(scores, paths);
  result.search.winner_points = result.winner.size();
  result.loop.length = loop_length(points, result.loop.points);
  result.loop.fitness = fitness(result.loop.points, scores, options);
  return result;
}

}  // namespace rimline
