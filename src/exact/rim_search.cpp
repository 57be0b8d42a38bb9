// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "exact/group_search.h"
#include "parallel.h"
#include "random.h"

namespace rimline::exact {
namespace {

constexpr double far_from_usual = 0.35;  // log_ratio beyond the spread that lets a hole start inside

// log_ratio beyond the spread of a triangle that closes an opening, whatever the gaps beside it are: a chord
// over a small hole leaves gaps that look like those at creases, since its other rim lies beyond them.
constexpr double plainly_too_large = 0.8;

// Whether a triangle is out of doubt for the gaps at its corners.
class Spared {
 public:
  Spared(const std::vector<std::uint8_t>& barred, LocalSizes& sizes) : barred_(barred), sizes_(sizes) {}

  bool may_be(const Triangle& x) const { return barred_[x[0]] || barred_[x[1]] || barred_[x[2]]; }
  bool operator()(const Triangle& x) const {
    return may_be(x) && sizes_.log_ratio(x) <= plainly_too_large + sizes_.spread(x);
  }

 private:
  const std::vector<std::uint8_t>& barred_;
  LocalSizes& sizes_;
};

// The vertices of the triangles, ascending.
std::vector<Index> vertices_of(const Complex& complex, const std::vector<Index>& triangles, const Run& run) {
  std::vector<std::uint8_t> marked(complex.vertices(), 0);
  parallel_for_each(triangles.size(), Stage::Loops, run, [&](Index i) {
    for (const Index v : complex.triangle(triangles[i]))
      std::atomic_ref(marked[v]).store(1, std::memory_order_relaxed);
  });
  return parallel_gather<Index>(marked.size(), Stage::Loops, run, [&](Index v, std::vector<Index>& found) {
    if (marked[v]) found.push_back(v);
  });
}

// The triangles that doubt starts from, ascending.
std::vector<Index> first_doubts(const Complex& complex, LocalSizes& sizes, const Spared& is_spared,
                                double doubtful, const Run& run) {
  // Limits tell that most triangles are nothing unusual.
  sizes.find_limits(far_from_usual, run);
  const auto asked =
      parallel_gather<Index>(complex.size(), Stage::Loops, run, [&](Index t, std::vector<Index>& found) {
        if (complex.is_at_rim(t) || sizes.may_exceed(t)) found.push_back(t);
      });
  sizes.find(vertices_of(complex, asked, run), run);
  return parallel_gather<Index>(asked.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
    const Index t = asked[i];
    const Triangle& x = complex.triangle(t);
    if (is_spared(x)) return;
    const double ratio = sizes.log_ratio(x);  // all sizes it needs are known
    if (complex.is_at_rim(t) ? ratio > doubtful : ratio > far_from_usual + sizes.spread(x))
      found.push_back(t);
  });
}

// The triangles beside these that are not among the seen yet, which they are then.
std::vector<Index> see_beside(const Complex& complex, const std::vector<Index>& triangles,
                              std::vector<std::uint8_t>& seen) {
  std::vector<Index> beside;
  beside.reserve(triangles.size());
  for (const Index t : triangles) {
    for (const Index other : complex.beside(t)) {
      if (other == none || seen[other]) continue;
      seen[other] = 1;
      beside.push_back(other);
    }
  }
  return beside;
}

// Finds the sizes at the corners of the triangles, most of which are known.
void find_missing(const Complex& complex, const std::vector<Index>& triangles, LocalSizes& sizes,
                  const Run& run) {
  auto missing =
      parallel_gather<Index>(triangles.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
        for (const Index v : complex.triangle(triangles[i])) {
          if (!sizes.is_known(v)) found.push_back(v);
        }
      });
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  sizes.find(missing, run);
}

// Those of the triangles that are doubtful where doubt is beside them.
std::vector<Index> more_doubts(const Complex& complex, const std::vector<Index>& triangles, LocalSizes& sizes,
                               const Spared& is_spared, double doubtful, const Run& run) {
  find_missing(complex, triangles, sizes, run);
  return parallel_gather<Index>(triangles.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
    const Triangle& x = complex.triangle(triangles[i]);
    if (!is_spared(x) && sizes.log_ratio(x) > doubtful) found.push_back(triangles[i]);
  });
}

std::vector<Index> doubtful_triangles(const Complex& complex, LocalSizes& sizes,
                                      const std::vector<std::uint8_t>& barred, double doubtful,
                                      const Run& run) {
  const Spared is_spared(barred, sizes);
  constexpr int deepest = 12;  // triangles from the rim
  std::vector<Index> all = first_doubts(complex, sizes, is_spared, doubtful, run);
  std::vector<std::uint8_t> seen(complex.size(), 0);
  for (const Index t : all) seen[t] = 1;
  std::vector<Index> layer = all;
  for (int depth = 1; depth < deepest && !layer.empty(); ++depth) {
    layer = more_doubts(complex, see_beside(complex, layer, seen), sizes, is_spared, doubtful, run);
    all.insert(all.end(), layer.begin(), layer.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// The position of an id among ascending ones, or `certain` where it is not among them.
std::uint32_t position(const std::vector<Index>& ids, Index id) {
  const auto at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? static_cast<std::uint32_t>(at - ids.begin()) : certain;
}

Doubt collect(const Complex& complex, LocalSizes& sizes, const std::vector<std::uint8_t>& barred,
              const RimSearchOptions& options, const Run& run) {
  Doubt doubt;
  const RimWeights& w = options.weights;
  doubt.triangles = doubtful_triangles(complex, sizes, barred, options.doubtful, run);
  doubt.vertices = vertices_of(complex, doubt.triangles, run);
  sizes.find(doubt.vertices, run);
  const std::size_t count = doubt.triangles.size();
  for (std::vector<double>* values : {&doubt.log_ratio, &doubt.spread, &doubt.gain}) values->resize(count);
  doubt.beside.resize(count);
  doubt.doubtful_beside.resize(count);
  doubt.contrast.resize(count);
  doubt.slots.resize(count);
  parallel_for_each(count, Stage::Loops, run, [&](Index i) {
    const Index t = doubt.triangles[i];
    const Triangle& x = complex.triangle(t);
    double largest = 0;
    for (const Index v : x) largest = std::max(largest, sizes.own(v));
    doubt.log_ratio[i] = sizes.log_ratio(x);
    const double own = std::clamp(std::log(complex.radius(t) / largest), -1.0, 3.0);
    doubt.spread[i] = sizes.spread(x);
    doubt.gain[i] = w.open + w.size * doubt.log_ratio[i] + w.own * own;
    for (int k = 0; k < 3; ++k) {
      const Index a = x[k], b = x[(k + 1) % 3], beside = complex.across(t, k);
      doubt.slots[i][k] = position(doubt.vertices, x[k]);
      doubt.beside[i][k] = beside;
      doubt.doubtful_beside[i][k] = beside == none ? certain : position(doubt.triangles, beside);
      doubt.contrast[i][k] = 0;
      if (beside == none) continue;
      const double usual = std::max(sizes.own(complex.apex(beside, a, b)), complex.radius(beside));
      const double c = std::log(complex.radius(t) / usual);
      doubt.contrast[i][k] = w.contrast * std::clamp(c - w.least_contrast, -1.0, 0.0);
    }
  });
  return doubt;
}

}  // namespace

RimSearch::RimSearch(const Complex& complex, LocalSizes& sizes, const std::vector<std::uint8_t>& barred,
                     const RimSearchOptions& options, const Run& run)
    : complex_(complex),
      options_(options),
      run_(run),
      doubt_(collect(complex, sizes, barred, options, run)),
      corners_(complex, doubt_.vertices, run),
      groups_(group(doubt_)) {}

RimSearchResult RimSearch::find(const std::vector<double>& evenness) const {
  return search(with(evenness), Kept(complex_.size(), 1), [](const Group&) { return true; });
}

RimSearchResult RimSearch::find_again(const std::vector<double>& evenness, const Kept& before) const {
  Kept kept = before;
  const auto at_even = [&](std::uint32_t i) {
    const Triangle& x = complex_.triangle(doubt_.triangles[i]);
    return std::any_of(x.begin(), x.end(), [&](Index v) { return evenness[v] > 0; });
  };
  const auto is_even = [&](const Group& group) { return std::any_of(group.begin(), group.end(), at_even); };
  for (const Group& group : groups_.all) {
    if (!is_even(group)) continue;
    for (const std::uint32_t i : group) kept[doubt_.triangles[i]] = 1;
  }
  return search(with(evenness), std::move(kept), is_even);
}

// The doubts where rims are even, or nothing is known of that.
Doubt RimSearch::with(const std::vector<double>& evenness) const {
  Doubt doubt = doubt_;
  for (std::size_t i = 0; !evenness.empty() && i < doubt.triangles.size(); ++i) {
    double even = 0;
    for (const Index v : complex_.triangle(doubt.triangles[i])) even += evenness[v] / 3;
    doubt.gain[i] -= options_.weights.even * even;
  }
  return doubt;
}

// Searches the groups for which wanted(group), all of whose triangles are kept first.
template <class Wanted>
RimSearchResult RimSearch::search(const Doubt& doubt, Kept kept, const Wanted& wanted) const {
  RimSearchResult result;
  result.kept = std::move(kept);
  result.doubtful = doubt.triangles.size();
  result.groups = groups_.all.size();
  result.history_best.assign(options_.generations, 0);
  result.history_mean.assign(options_.generations, 0);
  const double log_points = std::max(0.0, std::log(complex_.vertices() / 1000.0));
  // Groups share no vertex: none reads a byte of `kept` that another writes.
  constexpr std::size_t in_task = 16;
  std::vector<std::optional<GroupResult>> found(groups_.all.size());
  const auto search_slice = [&](std::size_t begin, std::size_t end) {
    GroupSearch search(doubt, groups_, corners_, options_, result.kept, log_points);
    for (std::size_t g = begin; g < end; ++g) {
      const Group& bits = groups_.all[g];
      if (wanted(bits)) found[g] = search.search(bits, Random(run_.seed, doubt.triangles[bits[0]]));
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

}  // namespace rimline::exact
