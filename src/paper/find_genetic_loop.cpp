// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/find_genetic_loop.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>

#include "paper/closed_paths.h"
#include "paper/genetic.h"
#include "paper/order.h"
#include "paper/winner.h"

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

// Takes the fittest of some chromosomes whose loop closes; false where none does.
bool take_fittest(const std::vector<ClosedPath>& chromosomes, LoopSource source, Points points,
                  const Neighbours& neighbours, const BoundaryScores& scores, const LoopOptions& options,
                  GeneticLoop& result) {
  for (std::size_t rank = 0; rank < chromosomes.size(); ++rank) {
    const ClosedPath& chromosome = chromosomes[rank];
    OrderedLoop loop = order_loop(points, neighbours, options.path_k, scores, chromosome.ids);
    if (!loop.goes_round && loop.points.size() <= static_cast<std::size_t>(options.path_k)) continue;
    result.loop.points = std::move(loop.points);
    result.winner = chromosome.ids;
    result.search.loop_from = source == LoopSource::Fittest && rank > 0 ? LoopSource::Later : source;
    result.search.winner_rank = rank;
    return true;
  }
  return false;
}

}  // namespace

GeneticLoop breed_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                       const ClosedPaths& paths, const LoopOptions& options, const Run& run) {
  Evolution evolution = evolve(paths.best, scores, options, run);
  GeneticLoop result;
  SearchSummary& search = result.search;
  search.starts = paths.starts;
  search.closed_paths = paths.closed;
  search.distinct_paths = paths.distinct;
  search.population = paths.best.size();
  search.steps = paths.steps;
  search.bound_hit = paths.bound_hit;
  search.history = std::move(evolution.history);
  result.history = std::move(evolution.best);
  // Crossover can break a closed path.
  if (!take_fittest(evolution.fittest, LoopSource::Fittest, points, neighbours, scores, options, result) &&
      !take_fittest(paths.best, LoopSource::InitialPath, points, neighbours, scores, options, result)) {
    throw_no_path(scores, paths);
  }
  search.winner_points = result.winner.size();
  search.winner_fitness = fitness(result.winner, scores, options);
  result.loop.length = loop_length(points, result.loop.points);
  result.loop.fitness = fitness(result.loop.points, scores, options);
  result.loop.probability = std::numeric_limits<double>::quiet_NaN();  // the paper defines none
  return result;
}

GeneticLoop find_genetic_loop(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run) {
  const ClosedPaths paths = find_closed_paths(neighbours, scores, options, run);
  if (paths.best.empty()) throw_no_path(scores, paths);
  return breed_loop(points, neighbours, scores, paths, options, run);
}

}  // namespace rimline
