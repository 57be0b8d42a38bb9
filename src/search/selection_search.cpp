// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/selection_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "base/model.h"
#include "base/parallel.h"
#include "base/random.h"
#include "search/group_search.h"

namespace rimline {
SelectionSearch::SelectionSearch(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                                 const std::vector<std::uint8_t>& excluded, const SearchOptions& options,
                                 const Run& run)
    : set_(set),
      options_(options),
      run_(run),
      candidates_(find_candidates(set, sizes, samples, excluded, options, run)),
      corners_(set, candidates_.vertices, run),
      groups_(group_candidates(candidates_)) {}

SearchResult SelectionSearch::find(const std::vector<double>& evenness) const {
  return search(with(evenness), Selection(set_.size(), 1), [](const CandidateGroup&) { return true; });
}

SearchResult SelectionSearch::find_again(const std::vector<double>& evenness, const Selection& before) const {
  Selection selected = before;
  const auto at_even = [&](std::uint32_t i) {
    const Triangle& x = set_.triangle(candidates_.triangles[i]);
    return std::any_of(x.begin(), x.end(), [&](Index v) { return evenness[v] > 0; });
  };
  const auto is_even = [&](const CandidateGroup& group) {
    return std::any_of(group.begin(), group.end(), at_even);
  };
  for (const CandidateGroup& group : groups_.all) {
    if (!is_even(group)) continue;
    for (const std::uint32_t i : group) selected[candidates_.triangles[i]] = 1;
  }
  return search(with(evenness), std::move(selected), is_even);
}

// The candidates with the evenness of rims, which may be empty.
Candidates SelectionSearch::with(const std::vector<double>& evenness) const {
  Candidates candidates = candidates_;
  if (evenness.empty()) return candidates;
  for (const Index v : candidates.vertices) candidates.even.push_back(evenness[v]);
  for (std::size_t i = 0; i < candidates.triangles.size(); ++i) {
    double even = 0;
    for (const Index v : set_.triangle(candidates.triangles[i])) even += evenness[v] / 3;
    candidates.gain[i] -= options_.weights.even * even;
  }
  return candidates;
}

// Searches the groups for which wanted(group) is true. All their triangles must be selected at first.
template <class Wanted>
SearchResult SelectionSearch::search(const Candidates& candidates, Selection selected,
                                     const Wanted& wanted) const {
  SearchResult result;
  result.selected = std::move(selected);
  result.doubtful = candidates.triangles.size();
  result.groups = groups_.all.size();
  result.history_best.assign(options_.generations, 0);
  result.history_mean.assign(options_.generations, 0);
  const double log_points = std::max(0.0, std::log(set_.vertices() / model::prior_points));
  // Groups share no vertex: none reads a byte of `selected` that another writes.
  constexpr std::size_t in_task = 16;  // [speed]
  std::vector<std::optional<GroupResult>> found(groups_.all.size());
  const auto search_slice = [&](std::size_t begin, std::size_t end) {
    GroupSearch search(candidates, groups_, corners_, options_, result.selected, log_points);
    for (std::size_t g = begin; g < end; ++g) {
      const CandidateGroup& bits = groups_.all[g];
      // The stream depends on the group alone, not on its number among the others.
      if (wanted(bits)) found[g] = search.search(bits, Random(run_.seed, bits.size()));
    }
  };
  parallel_slices(groups_.all.size(), Stage::Loops, run_, search_slice, in_task);
  run_.check_cancel();
  for (const auto& g : found) {
    if (!g) continue;
    result.greedy += g->greedy;
    result.best += g->best;
    for (std::size_t i = 0; i < result.history_best.size(); ++i) {
      const std::size_t last = std::min(i, g->history_best.size() - 1);
      result.history_best[i] += g->history_best[last];
      result.history_mean[i] += g->history_mean[last];
    }
  }
  return result;
}

}  // namespace rimline
