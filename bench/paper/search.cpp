// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/search.h"

#include <algorithm>
#include <limits>

#include "paper/fitness.h"
#include "paper/order.h"
#include "paper/winner.h"

namespace rimline::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

// Where the points lie in the box of the set, from 0 to 1 along x, y and z.
Json place_in_box(const PointSet& set, const std::vector<Index>& ids) {
  Json box = Json::array();
  for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
    Range all, these;
    for (const Point& p : set.points) all = {std::min(all.low, p.*axis), std::max(all.high, p.*axis)};
    for (const Index i : ids)
      these = {std::min(these.low, set.points[i].*axis), std::max(these.high, set.points[i].*axis)};
    const double size = std::max(all.high - all.low, 1e-300);
    box.push_back({(these.low - all.low) / size, (these.high - all.low) / size});
  }
  return box;
}

void put_coverage(Json& json, const PointSet& set, const std::vector<Index>& ids) {
  json["box"] = place_in_box(set, ids);
  if (set.rim.empty()) return;
  json["covers"] = share_near(set, set.rim, ids);
  json["on_rim"] = share_near(set, ids, set.rim);
}

// A path, and the loop that is made of it.
Json measure_path(const PointSet& set, const Paths& paths, const ClosedPath& path,
                  const LoopOptions& options) {
  Json json{{"points", path.ids.size()}, {"e", fitness(path.ids, paths.scores, options)}};
  put_coverage(json, set, path.ids);
  const OrderedLoop loop = order_loop(set.points, set.neighbours, options.path_k, paths.scores, path.ids);
  json["loop"] = {{"points", loop.points.size()}, {"goes_round", loop.goes_round}};
  put_coverage(json["loop"], set, loop.points);
  return json;
}

}  // namespace

Paths find_paths(const PointSet& set, BoundaryScores scores, const LoopOptions& options) {
  LoopOptions all = options;
  all.population = std::numeric_limits<int>::max();
  Paths paths{std::move(scores), {}};
  paths.found = find_closed_paths(set.neighbours, paths.scores, all, {});
  return paths;
}

ClosedPaths fittest_of(const Paths& paths, const LoopOptions& options) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < paths.found.best.size(); ++i)
    order.emplace_back(-log_fitness(paths.found.best[i].ids, paths.scores, options), i);
  const auto& all = paths.found.best;
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : all[a.second].ids < all[b.second].ids;
  });
  ClosedPaths fittest = {.best = {},
                         .starts = paths.found.starts,
                         .closed = paths.found.closed,
                         .distinct = paths.found.distinct,
                         .steps = paths.found.steps,
                         .bound_hit = paths.found.bound_hit};
  for (const auto& [minus_fitness, i] : order) {
    if (fittest.best.size() == static_cast<std::size_t>(options.population)) break;
    fittest.best.push_back({all[i].ids, -minus_fitness});
  }
  return fittest;
}

Json measure_run(const PointSet& set, const Paths& paths, const LoopOptions& options, std::uint64_t seed) {
  if (paths.found.best.empty()) return nullptr;
  Run run;
  run.seed = seed;
  const GeneticLoop found =
      breed_loop(set.points, set.neighbours, paths.scores, fittest_of(paths, options), options, run);
  const SearchSummary& search = found.search;
  Json json{{"seed", seed},
            {"e_0", search.history.front().best},
            {"e_K", search.history.back().best},
            {"winner", found.winner.size()},
            {"e_winner", search.winner_fitness},
            {"from", name(search.loop_from)},
            {"rank", search.winner_rank},
            {"loop", found.loop.points.size()},
            {"length", found.loop.length}};
  put_coverage(json, set, found.loop.points);
  return json;
}

Json measure_best_paths(const PointSet& set, const Paths& paths, const LoopOptions& options) {
  if (paths.found.best.empty()) return nullptr;
  const ClosedPaths fittest = fittest_of(paths, options);
  Json json{{"starts", paths.found.starts},
            {"closed", paths.found.closed},
            {"distinct", paths.found.distinct},
            {"bound_hit", paths.found.bound_hit},
            {"fittest", measure_path(set, paths, fittest.best.front(), options)}};
  if (set.rim.empty()) return json;
  const ClosedPath* widest = nullptr;
  double covers = -1;
  for (const ClosedPath& path : paths.found.best) {
    const double share = share_near(set, set.rim, path.ids);
    if (share <= covers) continue;
    covers = share;
    widest = &path;
  }
  json["widest"] = measure_path(set, paths, *widest, options);
  return json;
}

Json measure_plateau(const PointSet& set, const Paths& paths, const LoopOptions& options) {
  if (paths.found.best.empty() || set.rim.empty()) return nullptr;
  const auto row = [&](const LoopOptions& form) {
    const ClosedPaths fittest = fittest_of(paths, form);
    return share_near(set, set.rim, fittest.best.front().ids);
  };
  LoopOptions form = options;
  form.score_form = ScoreForm::Capped;
  Json json;
  for (const char* cap : {"1e-1", "3e-2", "1e-2", "3e-3", "1e-3", "3e-4", "1e-4", "1e-5", "1e-6", "1e-7",
                          "1e-8", "1e-10", "1e-12"}) {
    form.score_cap = std::stod(cap);
    json[cap] = row(form);
  }
  form.score_form = ScoreForm::Printed;
  json["printed"] = row(form);
  form.score_form = ScoreForm::Log;
  json["log"] = row(form);
  return json;
}

}  // namespace rimline::bench
