// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/candidates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "search/groups.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

// A lattice of unit step with a round hole in it that proposed triangles reach into.
struct Holed : ProposedSurface {
  Holed() : ProposedSurface(points_around_hole()), sizes(set, neighbours) {}

  static std::vector<Point> points_around_hole() {
    std::vector<Point> points;
    for (int y = -10; y <= 10; ++y) {
      for (int x = -10; x <= 10; ++x) {
        if (std::hypot(x, y) >= 2.8) points.push_back({x + 0.01 * y, y + 0.02 * x, 0});
      }
    }
    return points;
  }

  Candidates find(std::uint8_t mark) const {
    const Samples samples{points, neighbours, spacing, frames};
    return find_candidates(set, sizes, samples, std::vector<std::uint8_t>(points.size(), mark), {}, {});
  }

  LocalSizes sizes;
};

Index position(const std::vector<Index>& ids, Index id) {
  const auto at = std::find(ids.begin(), ids.end(), id);
  return at == ids.end() ? none : static_cast<Index>(at - ids.begin());
}

}  // namespace

TEST_CASE("candidates are the large triangles over a hole, none of the even lattice around it") {
  const Holed holed;
  const Candidates found = holed.find(0);
  REQUIRE(found.triangles.size() > 4);
  CHECK(std::is_sorted(found.triangles.begin(), found.triangles.end()));
  for (const Index t : found.triangles) {
    const Triangle& x = holed.set.triangle(t);
    const Point middle = (1.0 / 3) * (holed.points[x[0]] + holed.points[x[1]] + holed.points[x[2]]);
    CHECK(norm(middle) < 3.5);
  }
  for (Index t = 0; t < holed.set.size(); ++t) {
    if (holed.set.radius(t) > 2) CHECK(position(found.triangles, t) != none);
  }
}

TEST_CASE("where all points are excluded only what is plainly too large is a candidate") {
  const Holed holed;
  const Candidates all = holed.find(0), plain = holed.find(1);
  CHECK(plain.triangles.size() <= all.triangles.size());
  for (std::size_t i = 0; i < plain.triangles.size(); ++i) {
    CHECK(plain.log_ratio[i] > SearchOptions{}.doubtful);
    CHECK(plain.log_ratio[i] > 0.8 + plain.spread[i]);
  }
}

TEST_CASE("positions of candidates, of those beside them and of their vertices are those of a search") {
  const Holed holed;
  const Candidates found = holed.find(0);
  for (std::size_t i = 0; i < found.triangles.size(); ++i) {
    const Index t = found.triangles[i];
    for (int k = 0; k < 3; ++k) {
      CHECK(found.beside[i][k] == holed.set.across(t, k));
      const Index at = found.beside[i][k] == none ? none : position(found.triangles, found.beside[i][k]);
      CHECK(found.candidate_beside[i][k] == (at == none ? not_candidate : static_cast<std::uint32_t>(at)));
      CHECK(found.vertices[found.slots[i][k]] == holed.set.triangle(t)[k]);
    }
  }
}

TEST_CASE("no vertex is in two groups, and each candidate is in one, at its place") {
  const Holed holed;
  const Candidates found = holed.find(0);
  const CandidateGroups groups = group_candidates(found);
  std::vector<int> group_of(found.vertices.size(), -1);
  std::size_t sum = 0;
  for (std::size_t g = 0; g < groups.all.size(); ++g) {
    sum += groups.all[g].size();
    for (std::size_t k = 0; k < groups.all[g].size(); ++k) {
      const std::uint32_t i = groups.all[g][k];
      CHECK(groups.place[i] == k);
      for (const std::uint32_t slot : found.slots[i]) {
        CHECK((group_of[slot] == -1 || group_of[slot] == static_cast<int>(g)));
        group_of[slot] = static_cast<int>(g);
      }
    }
  }
  CHECK(sum == found.triangles.size());
}
