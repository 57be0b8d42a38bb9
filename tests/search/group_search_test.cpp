// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/group_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

std::vector<Point> random_square() {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  return points;
}

// A surface, and some of its triangles that are doubted for no reason.
struct Doubted : ProposedSurface {
  Candidates candidates;

  explicit Doubted(double share) : ProposedSurface(random_square()) {
    Random random(7);
    for (Index t = 0; t < set.size(); ++t) {
      if (random.uniform() < share) candidates.triangles.push_back(t);
    }
    for (const Index t : candidates.triangles) {
      for (const Index v : set.triangle(t)) candidates.vertices.push_back(v);
    }
    std::sort(candidates.vertices.begin(), candidates.vertices.end());
    candidates.vertices.erase(std::unique(candidates.vertices.begin(), candidates.vertices.end()),
                              candidates.vertices.end());
    const auto position = [](const std::vector<Index>& ids, Index id) {
      const auto at = std::find(ids.begin(), ids.end(), id);
      return at == ids.end() ? not_candidate : static_cast<std::uint32_t>(at - ids.begin());
    };
    for (const Index t : candidates.triangles) {
      candidates.gain.push_back(4 * random.uniform());
      candidates.log_ratio.push_back(0.7 + random.uniform());
      candidates.spread.push_back(0.5);
      std::array<Index, 3>& beside = candidates.beside.emplace_back();
      auto& contrast = candidates.contrast.emplace_back();
      auto &doubtful = candidates.candidate_beside.emplace_back(), &slots = candidates.slots.emplace_back();
      for (int k = 0; k < 3; ++k) {
        beside[k] = set.across(t, k);
        contrast[k] = beside[k] == none ? 0 : -random.uniform();
        doubtful[k] = position(candidates.triangles, beside[k]);
        slots[k] = position(candidates.vertices, set.triangle(t)[k]);
      }
    }
  }
};

// From the definition.
double fitness_of(const CandidateGroup& group, const Candidates& candidates, const FanCorners& corners,
                  const Selection& selected) {
  double sum = 0;
  std::vector<std::uint32_t> slots;
  for (const std::uint32_t b : group) {
    slots.insert(slots.end(), candidates.slots[b].begin(), candidates.slots[b].end());
    if (selected[candidates.triangles[b]]) continue;
    double worth = candidates.gain[b];
    for (int k = 0; k < 3; ++k) {
      if (candidates.beside[b][k] != none && selected[candidates.beside[b][k]])
        worth += candidates.contrast[b][k];
    }
    sum += worth;
  }
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  for (const std::uint32_t slot : slots) sum -= corners.cost(slot, selected, {});
  return sum;
}

}  // namespace

TEST_CASE("groups share no vertex, and hold each doubtful triangle once") {
  const Doubted cloud(0.1);
  const CandidateGroups groups = group_candidates(cloud.candidates);
  std::vector<std::size_t> group_of(cloud.points.size(), groups.all.size());
  std::size_t count = 0, shared = 0;
  for (std::size_t g = 0; g < groups.all.size(); ++g) {
    for (std::size_t i = 0; i < groups.all[g].size(); ++i) {
      ++count;
      CHECK(groups.place[groups.all[g][i]] == i);
      for (const Index v : cloud.set.triangle(cloud.candidates.triangles[groups.all[g][i]])) {
        shared += group_of[v] != groups.all.size() && group_of[v] != g;
        group_of[v] = g;
      }
    }
  }
  CHECK(count == cloud.candidates.triangles.size());
  CHECK(shared == 0);
  CHECK(groups.all.size() > 20);
}

TEST_CASE("what flips gain adds up to the fitness, in groups of one triangle and of hundreds") {
  for (const double share : {0.1, 0.5, 0.95}) {  // at last some vertices have more bits than are in a table
    const Doubted cloud(share);
    const CandidateGroups groups = group_candidates(cloud.candidates);
    const FanCorners corners(cloud.set, cloud.candidates.vertices, {});
    Selection selected(cloud.set.size(), 1);
    const SearchOptions options;
    GroupSearch search(cloud.candidates, groups, corners, options, selected, 0);
    Random random(5);
    std::size_t largest = 0, wrong = 0;
    for (const CandidateGroup& bits : groups.all) {
      largest = std::max(largest, bits.size());
      search.start(bits);
      double fitness = search.fitness();
      for (int round = 0; round < 40; ++round) {
        std::vector<std::uint32_t> which;
        const double taken = round % 2 == 0 ? 0 : 0.3;
        for (std::uint32_t i = 0; i < bits.size(); ++i) {
          if (random.uniform() < taken) which.push_back(i);
        }
        if (which.empty()) which.push_back(static_cast<std::uint32_t>(random.below(bits.size())));
        fitness += search.flip(which);
        const double now = fitness_of(bits, cloud.candidates, corners, selected);
        wrong += search.fitness() != now;
        wrong += std::abs(fitness - now) > 1e-9 * (1 + std::abs(now));
      }
    }
    CHECK(wrong == 0);
    CHECK(largest > (share < 0.3 ? 5 : 200));
  }
}

TEST_CASE("the search finds the best of all ways in small groups, and says what it is worth in any") {
  const Doubted cloud(0.15);
  const CandidateGroups groups = group_candidates(cloud.candidates);
  const FanCorners corners(cloud.set, cloud.candidates.vertices, {});
  Selection selected(cloud.set.size(), 1);
  SearchOptions options;
  options.weights.hole_prior = options.weights.hole_prior_spread = options.weights.hole_prior_points = 0;
  GroupSearch search(cloud.candidates, groups, corners, options, selected, 0);
  std::size_t small = 0, missed = 0, wrong = 0;
  for (const CandidateGroup& bits : groups.all) {
    const GroupResult found = search.search(bits, Random(1, bits[0]));
    const double now = fitness_of(bits, cloud.candidates, corners, selected);
    wrong += std::abs(found.best - now) > 1e-9 * (1 + std::abs(now));
    if (bits.size() > 8) continue;
    ++small;
    Selection other = selected;
    double best = -1e300;
    for (unsigned mask = 0; mask < 1u << bits.size(); ++mask) {
      for (std::size_t i = 0; i < bits.size(); ++i)
        other[cloud.candidates.triangles[bits[i]]] = mask >> i & 1;
      best = std::max(best, fitness_of(bits, cloud.candidates, corners, other));
    }
    missed += best > found.best + 1e-9;
  }
  CHECK(wrong == 0);
  CHECK(small > 20);
  CHECK(missed <= small / 20);
}
