// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/select.h"

#include <atomic>
#include <utility>
#include <vector>

#include "base/model.h"
#include "base/parallel.h"
#include "evidence/jaggedness.h"
#include "evidence/rim_probability.h"
#include "search/open_ears.h"
#include "search/selection_search.h"
#include "surface/local_size.h"
#include "surface/propose.h"

namespace rimline {
namespace {

SearchOptions options_for(const SamplingProfile& sampling, const BoundaryLoopOptions& options) {
  SearchOptions o;
  o.population = options.rim_population;
  o.is_greedy = options.search == RimSearch::Greedy;
  o.generations = options.search == RimSearch::Genetic ? options.rim_generations : 0;
  if (sampling.noise.noise == 0) return o;
  // Noise spreads the sizes of triangles, but opens no holes as chance does among random points.
  constexpr double by_noise = model::FitnessModel{}.hole_prior_noise;
  const auto blend = [&](double cost) { return by_noise + (cost - by_noise) * sampling.noise.irregular; };
  o.weights.hole_prior = blend(o.weights.hole_prior);
  o.weights.hole_prior_spread = blend(o.weights.hole_prior_spread);
  return o;
}

// For the search for ears, after the openings are found.
SearchOptions along_rims(const SearchOptions& first) {
  SearchOptions o = first;
  o.least_odds = model::candidate_least_odds;
  o.weights = weights_along_rims(first.weights);
  o.weights.open -= model::ear_margin;
  return o;
}

SelectionSummary added(SelectionSummary summary, const SearchResult& found) {
  summary.doubtful += found.doubtful;
  summary.groups += found.groups;
  summary.greedy += found.greedy;
  summary.best += found.best;
  for (std::size_t i = 0; i < summary.history.size(); ++i) {
    summary.history[i].best += found.history_best[i];
    summary.history[i].mean += found.history_mean[i];
  }
  return summary;
}

// Result of the two searches over all proposed triangles.
struct FirstFound {
  Selection selection;
  std::vector<double> even;  // evenness of the rim at each point, or empty
  SelectionSummary summary;
};

// A rim that is even nearly everywhere is likely even in the rest, so a second search takes evenness as
// known. Not under noise, which makes even rims uneven.
FirstFound search_twice(const SelectionSearch& search, const TriangleSet& set, bool tells_even,
                        const SearchOptions& options, const Run& run) {
  SelectionSummary summary;
  summary.history.assign(options.generations, {});
  SearchResult first = search.find({});
  summary = added(std::move(summary), first);
  if (!tells_even) return {std::move(first.selected), {}, std::move(summary)};
  std::vector<double> even = evenness(set.points(), walk_rims(set, first.selected, run), run);
  SearchResult again = search.find_again(even, first.selected);
  return {std::move(again.selected), std::move(even), added(std::move(summary), again)};
}

// The points of the triangles that are left out.
std::vector<std::uint8_t> points_of_others(const TriangleSet& set, const Selection& selection,
                                           const Run& run) {
  std::vector<std::uint8_t> marked(set.vertices(), 0);
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) {
    if (selection[t]) return;
    for (const Index v : set.triangle(t)) std::atomic_ref(marked[v]).store(1, std::memory_order_relaxed);
  });
  return marked;
}

}  // namespace

std::vector<std::uint8_t> find_excluded(const TriangleSet& set, const Samples& samples,
                                        const SamplingProfile& sampling, const Run& run) {
  const Selection all(set.size(), 1);
  const RimEvidence evidence{set, all, {}, samples, sampling};
  std::vector<std::uint8_t> excluded(samples.points.size(), 0);
  for (const auto& rim : walk_rims(set, all, run)) {
    if (rim.size() < model::gap_least || rim_probability(rim, evidence, run) >= model::gap_most) continue;
    for (const Index v : rim) excluded[v] = 1;
  }
  return excluded;
}

SelectedSurface select(TriangleSet set, const Samples& samples, const SamplingProfile& sampling,
                       const BoundaryLoopOptions& options, const Run& run) {
  if (sampling.is_range_image) {
    SelectedSurface all{std::move(set), {}, {}};
    all.selection.assign(all.set.size(), 1);
    all.summary.history.assign(options_for(sampling, options).generations, {});
    return all;
  }
  const SearchOptions o = options_for(sampling, options);
  LocalSizes sizes(set, samples.neighbours, run);
  FirstFound first =
      search_twice(SelectionSearch(set, sizes, samples, find_excluded(set, samples, sampling, run), o, run),
                   set, sampling.noise.noise == 0, o, run);
  // Large triangles that are left out had hidden ears of the rim. The search runs again without them.
  std::vector<std::uint8_t> changed = points_of_others(set, first.selection, run);
  set.keep_only(first.selection, run);
  const Index before = set.size();
  set = with_missing_ears(std::move(set), samples.spacing, model::refilled_largest, run);
  for (Index t = before; t < set.size(); ++t) {
    for (const Index v : set.triangle(t)) changed[v] = 1;
  }
  sizes.forget(changed, run);
  const auto excluded = find_excluded(set, samples, sampling, run);
  const SearchResult open = SelectionSearch(set, sizes, samples, excluded, o, run).find(first.even);
  SelectionSummary summary = added(std::move(first.summary), open);
  const SearchResult ears =
      SelectionSearch(set, sizes, samples, excluded, along_rims(o), run).find(first.even);
  Selection selection = open_ears(set, open.selected, ears.selected, model::ear_most, run);
  return {std::move(set), std::move(selection), std::move(summary)};
}

}  // namespace rimline
