// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangles.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <utility>

#include "evidence/jaggedness.h"
#include "search/candidates.h"
#include "search/fitness.h"
#include "search/triangle_measures.h"

using namespace rimline;

namespace {

constexpr double least_at_rim = -0.2;  // log ratio of a triangle at the rim that is asked

using Edge = std::pair<Index, Index>;

Edge edge_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// The true loops, as edges.
struct Truth {
  std::set<Edge> edges;
  std::vector<int> edges_at;  // of each point
};

Truth truth_of(const std::vector<std::vector<Index>>& loops, Index points) {
  Truth truth{{}, std::vector<int>(points, 0)};
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      truth.edges.insert(edge_of(a, b));
      ++truth.edges_at[a];
      ++truth.edges_at[b];
    }
  }
  return truth;
}

// What the true loops enclose: from the triangles that have a point off the loops over all edges but theirs.
Selection enclosed(const TriangleSet& set, const Truth& truth) {
  Selection inside(set.size(), 0);
  std::vector<Index> queue;
  const auto take = [&](Index t) {
    if (inside[t]) return;
    inside[t] = 1;
    queue.push_back(t);
  };
  for (Index t = 0; t < set.size(); ++t) {
    for (const Index v : set.triangle(t)) {
      if (truth.edges_at[v] == 0) take(t);
    }
  }
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Triangle x = set.triangle(queue[k]);
    for (int i = 0; i < 3; ++i) {
      const Index beside = set.across(queue[k], i);
      if (beside != none && !truth.edges.contains(edge_of(x[i], x[(i + 1) % 3]))) take(beside);
    }
  }
  return inside;
}

// Whether all true edges at a point end the enclosed triangles.
std::vector<std::uint8_t> is_told(const TriangleSet& set, const Truth& truth, const Selection& inside) {
  std::vector<int> ends(set.vertices(), 0);
  for (const auto& [a, b] : truth.edges) {
    Index found[2];
    int count = 0;
    for (int k = set.edge(a, b, found) - 1; k >= 0; --k) count += inside[found[k]];
    if (count != 1) continue;
    ++ends[a];
    ++ends[b];
  }
  std::vector<std::uint8_t> told(set.vertices());
  for (Index v = 0; v < set.vertices(); ++v) told[v] = ends[v] == truth.edges_at[v];
  return told;
}

std::vector<Index> asked_triangles(const TriangleSet& set, const LocalSizes& sizes,
                                   const Candidates& candidates, const std::vector<std::uint8_t>& excluded,
                                   const std::vector<std::uint8_t>& told) {
  std::vector<Index> asked = candidates.triangles;
  for (Index t = 0; t < set.size(); ++t) {
    const Triangle& x = set.triangle(t);
    if (set.is_at_rim(t) && sizes.log_ratio(x) > least_at_rim && !excluded[x[0]] && !excluded[x[1]] &&
        !excluded[x[2]])
      asked.push_back(t);
  }
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  std::erase_if(asked, [&](Index t) {
    const Triangle& x = set.triangle(t);
    return !told[x[0]] || !told[x[1]] || !told[x[2]];
  });
  return asked;
}

// What its contrast to the triangles beside it changes by where it is left out.
double contrast(const TriangleSet& set, const LocalSizes& sizes, const Selection& inside, Index t) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const Index beside = set.across(t, k);
    if (beside == none) continue;
    if (inside[beside]) sum += lack_of_contrast(set, sizes, t, k, {});
    for (int j = 0; j < 3 && !inside[beside]; ++j) {
      if (set.across(beside, j) == t) sum -= lack_of_contrast(set, sizes, beside, j, {});
    }
  }
  return sum;
}

}  // namespace

void print_triangles(const SelectedSurface& surface, const Samples& samples, const SamplingProfile& sampling,
                     const std::vector<std::vector<Index>>& loops, const Run& run) {
  const TriangleSet& set = surface.set;
  const LocalSizes sizes(set, samples.neighbours, run);
  const Truth truth = truth_of(loops, set.vertices());
  const Selection inside = enclosed(set, truth);
  const std::vector<std::uint8_t> excluded = find_excluded(set, samples, sampling, run);
  const Candidates candidates = find_candidates(set, sizes, samples, excluded, {}, run);
  const auto asked = asked_triangles(set, sizes, candidates, excluded, is_told(set, truth, inside));
  const auto even = evenness(set.points(), walk_rims(set, inside, run), run);
  Selection now = inside;
  for (const Index t : asked) {
    const Triangle x = set.triangle(t);
    const FanCorners corners(set, x, run);
    const TriangleMeasures m = measure_triangle(set, sizes, samples, t, weights_along_rims({}));
    double all_even = 0, pinches = 0;
    std::array<double, 3> turning{}, on_even{};  // slight, moderate and all
    for (std::size_t k = 0; k < 3; ++k) {
      now[t] = 0;
      const auto out = corners.turns(k, now);
      now[t] = 1;
      const auto in = corners.turns(k, now);
      now[t] = inside[t];
      const std::array<double, 3> more{out.slight - in.slight, out.moderate - in.moderate,
                                       out.sharp - in.sharp};
      for (std::size_t i = 0; i < 3; ++i) {
        turning[i] -= more[i];
        on_even[i] -= even[x[k]] * more[i];
      }
      pinches -= out.pinches - in.pinches + 10 * (out.isolated - in.isolated);
      all_even -= even[x[k]] / 3;
    }
    std::printf("triangles,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g", !inside[t],
                m.log_ratio, m.own, m.tip, m.spread, all_even, turning[0], turning[1], turning[2], on_even[0],
                on_even[1], on_even[2], contrast(set, sizes, inside, t), pinches);
    std::printf(",%.6g,%.6g,%.6g,%.6g", m.sides.one_sided, m.sides.least_one_sided, m.sides.toward,
                m.sides.least_toward);
    std::printf("\n");
  }
}
