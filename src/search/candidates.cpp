// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/candidates.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "search/triangle_measures.h"

namespace rimline {
namespace {

constexpr double far_from_usual = model::candidate_inside;

// log_ratio beyond the spread. A larger triangle is a candidate even at an excluded vertex: a chord over a
// small hole leaves gaps that look like those at creases, since the other rim of the hole lies beyond them.
constexpr double plainly_too_large = model::candidate_plain;

// Whether a triangle is no candidate because of the gaps at its corners.
class Spared {
 public:
  Spared(const std::vector<std::uint8_t>& excluded, const LocalSizes& sizes)
      : excluded_(excluded), sizes_(sizes) {}

  bool may_be(const Triangle& x) const { return excluded_[x[0]] || excluded_[x[1]] || excluded_[x[2]]; }
  bool operator()(const Triangle& x) const {
    return may_be(x) && sizes_.log_ratio(x) <= plainly_too_large + sizes_.spread(x);
  }

 private:
  const std::vector<std::uint8_t>& excluded_;
  const LocalSizes& sizes_;
};

// Whether a triangle at the rim may be left out.
class Doubt {
 public:
  Doubt(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples, const SearchOptions& options)
      : set_(set), sizes_(sizes), samples_(samples), options_(options) {}

  bool operator()(Index t, double log_ratio) const {
    return log_ratio > options_.doubtful ||
           (std::isfinite(options_.least_odds) &&
            log_odds_alone(measure_triangle(set_, sizes_, samples_, t, options_.weights), options_.weights) >
                options_.least_odds);
  }

 private:
  const TriangleSet& set_;
  const LocalSizes& sizes_;
  const Samples& samples_;
  const SearchOptions& options_;
};

// The vertices of the triangles, ascending.
std::vector<Index> vertices_of(const TriangleSet& set, const std::vector<Index>& triangles, const Run& run) {
  std::vector<std::uint8_t> marked(set.vertices(), 0);
  parallel_for_each(triangles.size(), Stage::Loops, run, [&](Index i) {
    for (const Index v : set.triangle(triangles[i]))
      std::atomic_ref(marked[v]).store(1, std::memory_order_relaxed);
  });
  return parallel_gather<Index>(marked.size(), Stage::Loops, run, [&](Index v, std::vector<Index>& found) {
    if (marked[v]) found.push_back(v);
  });
}

// The candidates that are found without their neighbours, ascending.
std::vector<Index> first_candidates(const TriangleSet& set, const LocalSizes& sizes, const Spared& is_spared,
                                    const Doubt& is_doubtful, const Run& run) {
  // Limits show that most triangles have a usual size.
  sizes.find_limits(far_from_usual, run);
  const auto asked =
      parallel_gather<Index>(set.size(), Stage::Loops, run, [&](Index t, std::vector<Index>& found) {
        if (set.is_at_rim(t) || sizes.may_exceed(t)) found.push_back(t);
      });
  sizes.find(vertices_of(set, asked, run), run);
  return parallel_gather<Index>(asked.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
    const Index t = asked[i];
    const Triangle& x = set.triangle(t);
    if (is_spared(x)) return;
    const double ratio = sizes.log_ratio(x);  // all sizes it needs are known
    if (set.is_at_rim(t) ? is_doubtful(t, ratio) : ratio > far_from_usual + sizes.spread(x))
      found.push_back(t);
  });
}

// The neighbours of the triangles that are not marked as seen; marks them.
std::vector<Index> see_beside(const TriangleSet& set, const std::vector<Index>& triangles,
                              std::vector<std::uint8_t>& seen) {
  std::vector<Index> beside;
  beside.reserve(triangles.size());
  for (const Index t : triangles) {
    for (const Index other : set.beside(t)) {
      if (other == none || seen[other]) continue;
      seen[other] = 1;
      beside.push_back(other);
    }
  }
  return beside;
}

// Finds the sizes at the corners of the triangles, most of which are known.
void find_missing(const TriangleSet& set, const std::vector<Index>& triangles, const LocalSizes& sizes,
                  const Run& run) {
  auto missing =
      parallel_gather<Index>(triangles.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
        for (const Index v : set.triangle(triangles[i])) {
          if (!sizes.is_known(v)) found.push_back(v);
        }
      });
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  sizes.find(missing, run);
}

// The triangles that are doubtful when a neighbour is a candidate.
std::vector<Index> more_candidates(const TriangleSet& set, const std::vector<Index>& triangles,
                                   const LocalSizes& sizes, const Spared& is_spared, const Doubt& is_doubtful,
                                   const Run& run) {
  find_missing(set, triangles, sizes, run);
  return parallel_gather<Index>(triangles.size(), Stage::Loops, run, [&](Index i, std::vector<Index>& found) {
    const Triangle& x = set.triangle(triangles[i]);
    if (!is_spared(x) && is_doubtful(triangles[i], sizes.log_ratio(x))) found.push_back(triangles[i]);
  });
}

std::vector<Index> candidate_triangles(const TriangleSet& set, const LocalSizes& sizes,
                                       const std::vector<std::uint8_t>& excluded, const Doubt& is_doubtful,
                                       const Run& run) {
  const Spared is_spared(excluded, sizes);
  constexpr int deepest = model::candidate_deepest;
  std::vector<Index> all = first_candidates(set, sizes, is_spared, is_doubtful, run);
  std::vector<std::uint8_t> seen(set.size(), 0);
  for (const Index t : all) seen[t] = 1;
  std::vector<Index> layer = all;
  for (int depth = 1; depth < deepest && !layer.empty(); ++depth) {
    layer = more_candidates(set, see_beside(set, layer, seen), sizes, is_spared, is_doubtful, run);
    all.insert(all.end(), layer.begin(), layer.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// The position of an id in an ascending list, or `not_candidate` if it is not in the list.
std::uint32_t position(const std::vector<Index>& ids, Index id) {
  const auto at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? static_cast<std::uint32_t>(at - ids.begin()) : not_candidate;
}

}  // namespace

Candidates find_candidates(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                           const std::vector<std::uint8_t>& excluded, const SearchOptions& options,
                           const Run& run) {
  Candidates candidates;
  const FitnessWeights& w = options.weights;
  candidates.triangles = candidate_triangles(set, sizes, excluded, Doubt(set, sizes, samples, options), run);
  candidates.vertices = vertices_of(set, candidates.triangles, run);
  sizes.find(candidates.vertices, run);
  const std::size_t count = candidates.triangles.size();
  for (std::vector<double>* values : {&candidates.log_ratio, &candidates.spread, &candidates.gain})
    values->resize(count);
  candidates.beside.resize(count);
  candidates.candidate_beside.resize(count);
  candidates.contrast.resize(count);
  candidates.slots.resize(count);
  parallel_for_each(count, Stage::Loops, run, [&](Index i) {
    const Index t = candidates.triangles[i];
    const Triangle& x = set.triangle(t);
    const TriangleMeasures measures = measure_triangle(set, sizes, samples, t, w);
    candidates.log_ratio[i] = measures.log_ratio;
    candidates.spread[i] = measures.spread;
    candidates.gain[i] = log_odds_alone(measures, w);
    for (int k = 0; k < 3; ++k) {
      const Index beside = set.across(t, k);
      candidates.slots[i][k] = position(candidates.vertices, x[k]);
      candidates.beside[i][k] = beside;
      candidates.candidate_beside[i][k] =
          beside == none ? not_candidate : position(candidates.triangles, beside);
      candidates.contrast[i][k] = beside == none ? 0 : w.contrast * lack_of_contrast(set, sizes, t, k, w);
    }
  });
  return candidates;
}

}  // namespace rimline
