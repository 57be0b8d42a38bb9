// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "rimline/find_genetic_loop.h"
#include "shapes.h"

namespace rimline {
namespace {

bool is_rotation_or_reverse(std::vector<Index> loop, const std::vector<Index>& wanted) {
  if (loop.size() != wanted.size()) return false;
  for (int turn = 0; turn < 2; ++turn) {
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), wanted[0]), loop.end());
    if (loop == wanted) return true;
    std::reverse(loop.begin(), loop.end());
  }
  return false;
}

TEST_CASE("the band of candidates of a disc is ordered into its rim") {
  const auto disc = shapes::disc(14);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  std::vector<Index> band;
  for (Index i = 0; i < static_cast<Index>(disc.points.size()); ++i) {
    if (scores.candidate[i]) band.push_back(i);
  }
  REQUIRE(band.size() > disc.rim.size());  // the band is wider than the rim, or there is nothing to show
  CHECK(is_rotation_or_reverse(order_loop(disc.points, neighbours, 40, scores, band), disc.rim));
}

TEST_CASE("an open arc has no order") {
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i) points.push_back({1.0 * i * (i + 1), 0, 0});
  const Neighbours neighbours = find_neighbours(points, 1, {});
  const BoundaryScores scores{std::vector<double>(30, 5.0), std::vector<std::uint8_t>(30, 1),
                              std::vector<float>(30, 0.4f)};
  std::vector<Index> all(30);
  for (Index i = 0; i < 30; ++i) all[i] = i;
  CHECK(order_loop(points, neighbours, 1, scores, all).empty());
}

TEST_CASE("Algorithms 3.1 and 3.2 and the order find the rim of a bumpy disc") {
  const auto disc = shapes::disc(16, 0.3);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  const GeneticLoop found = find_genetic_loop(disc.points, neighbours, scores, {}, {});
  CHECK(is_rotation_or_reverse(found.loop.points, disc.rim));
  CHECK(found.search.history.size() == 101);
  CHECK(found.loop.length == doctest::Approx(loop_length(disc.points, disc.rim)));
}

TEST_CASE("a set without a closed path says so") {
  const auto disc = shapes::disc(14);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  BoundaryScores scores = score_boundary(disc.points, neighbours, {}, {});
  scores.candidate.assign(scores.candidate.size(), 0);
  CHECK_THROWS_AS(find_genetic_loop(disc.points, neighbours, scores, {}, {}), Error);
}

}  // namespace
}  // namespace rimline
