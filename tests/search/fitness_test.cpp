// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/fitness.h"

#include <doctest/doctest.h>

#include <array>
#include <numeric>
#include <vector>

#include "base/random.h"
#include "local/frame.h"
#include "local/star.h"
#include "rimline/neighbours.h"
#include "surface/propose.h"

using namespace rimline;

TEST_CASE("corners of many vertices, found in parts, cost what those of each vertex alone cost") {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto spacing = local_spacing(points, neighbours);
  const std::vector<Frame> frames = fit_frames(points, neighbours, {});
  const Stars stars = find_stars(points, neighbours, spacing, frames, {});
  const TriangleSet set = propose_surface(points, frames, stars, spacing, 3, {});
  Selection selected(set.size());
  for (std::uint8_t& bit : selected) bit = random.uniform() < 0.8;
  std::vector<Index> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  const FanCorners all(set, vertices, {});
  std::size_t wrong = 0;
  for (const Index v : vertices) {
    const FanCorners alone(set, std::array{v}, {});
    wrong += all.cost(static_cast<std::size_t>(v), selected, {}) != alone.cost(0, selected, {});
  }
  CHECK(wrong == 0);
}
