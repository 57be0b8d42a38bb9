// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/group_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "exact/surface.h"
#include "random.h"

using namespace rimline;
using namespace rimline::exact;

namespace {

std::vector<Point> random_square() {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  return points;
}

// A surface, and some of its triangles that are doubted for no reason.
struct Doubted : Surface {
  Doubt doubt;

  explicit Doubted(double share) : Surface(random_square()) {
    Random random(7);
    for (Index t = 0; t < complex.size(); ++t) {
      if (random.uniform() < share) doubt.triangles.push_back(t);
    }
    for (const Index t : doubt.triangles) {
      for (const Index v : complex.triangle(t)) doubt.vertices.push_back(v);
    }
    std::sort(doubt.vertices.begin(), doubt.vertices.end());
    doubt.vertices.erase(std::unique(doubt.vertices.begin(), doubt.vertices.end()), doubt.vertices.end());
    const auto position = [](const std::vector<Index>& ids, Index id) {
      const auto at = std::find(ids.begin(), ids.end(), id);
      return at == ids.end() ? certain : static_cast<std::uint32_t>(at - ids.begin());
    };
    for (const Index t : doubt.triangles) {
      doubt.gain.push_back(4 * random.uniform());
      doubt.log_ratio.push_back(0.7 + random.uniform());
      doubt.spread.push_back(0.5);
      std::array<Index, 3>& beside = doubt.beside.emplace_back();
      auto& contrast = doubt.contrast.emplace_back();
      auto &doubtful = doubt.doubtful_beside.emplace_back(), &slots = doubt.slots.emplace_back();
      for (int k = 0; k < 3; ++k) {
        beside[k] = complex.across(t, k);
        contrast[k] = beside[k] == none ? 0 : -random.uniform();
        doubtful[k] = position(doubt.triangles, beside[k]);
        slots[k] = position(doubt.vertices, complex.triangle(t)[k]);
      }
    }
  }
};

// From the definition.
double fitness_of(const Group& group, const Doubt& doubt, const Corners& corners, const Kept& kept) {
  double sum = 0;
  std::vector<std::uint32_t> slots;
  for (const std::uint32_t b : group) {
    slots.insert(slots.end(), doubt.slots[b].begin(), doubt.slots[b].end());
    if (kept[doubt.triangles[b]]) continue;
    double worth = doubt.gain[b];
    for (int k = 0; k < 3; ++k) {
      if (doubt.beside[b][k] != none && kept[doubt.beside[b][k]]) worth += doubt.contrast[b][k];
    }
    sum += worth;
  }
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  for (const std::uint32_t slot : slots) sum -= corners.cost(slot, kept, {});
  return sum;
}

}  // namespace

TEST_CASE("groups share no vertex, and hold each doubtful triangle once") {
  const Doubted cloud(0.1);
  const Groups groups = group(cloud.doubt);
  std::vector<std::size_t> group_of(cloud.points.size(), groups.all.size());
  std::size_t count = 0, shared = 0;
  for (std::size_t g = 0; g < groups.all.size(); ++g) {
    for (std::size_t i = 0; i < groups.all[g].size(); ++i) {
      ++count;
      CHECK(groups.place[groups.all[g][i]] == i);
      for (const Index v : cloud.complex.triangle(cloud.doubt.triangles[groups.all[g][i]])) {
        shared += group_of[v] != groups.all.size() && group_of[v] != g;
        group_of[v] = g;
      }
    }
  }
  CHECK(count == cloud.doubt.triangles.size());
  CHECK(shared == 0);
  CHECK(groups.all.size() > 20);
}

TEST_CASE("what flips gain adds up to the fitness, in groups of one triangle and of hundreds") {
  for (const double share : {0.1, 0.5, 0.95}) {  // at last some vertices have more bits than are in a table
    const Doubted cloud(share);
    const Groups groups = group(cloud.doubt);
    const Corners corners(cloud.complex, cloud.doubt.vertices, {});
    Kept kept(cloud.complex.size(), 1);
    const RimSearchOptions options;
    GroupSearch search(cloud.doubt, groups, corners, options, kept, 0);
    Random random(5);
    std::size_t largest = 0, wrong = 0;
    for (const Group& bits : groups.all) {
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
        const double now = fitness_of(bits, cloud.doubt, corners, kept);
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
  const Groups groups = group(cloud.doubt);
  const Corners corners(cloud.complex, cloud.doubt.vertices, {});
  Kept kept(cloud.complex.size(), 1);
  RimSearchOptions options;
  options.weights.birth = options.weights.birth_spread = options.weights.birth_points = 0;
  GroupSearch search(cloud.doubt, groups, corners, options, kept, 0);
  std::size_t small = 0, missed = 0, wrong = 0;
  for (const Group& bits : groups.all) {
    const GroupResult found = search.search(bits, Random(1, bits[0]));
    const double now = fitness_of(bits, cloud.doubt, corners, kept);
    wrong += std::abs(found.best - now) > 1e-9 * (1 + std::abs(now));
    if (bits.size() > 8) continue;
    ++small;
    Kept other = kept;
    double best = -1e300;
    for (unsigned mask = 0; mask < 1u << bits.size(); ++mask) {
      for (std::size_t i = 0; i < bits.size(); ++i) other[cloud.doubt.triangles[bits[i]]] = mask >> i & 1;
      best = std::max(best, fitness_of(bits, cloud.doubt, corners, other));
    }
    missed += best > found.best + 1e-9;
  }
  CHECK(wrong == 0);
  CHECK(small > 20);
  CHECK(missed <= small / 20);
}
