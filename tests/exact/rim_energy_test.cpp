// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_energy.h"

#include <doctest/doctest.h>

#include <array>
#include <numeric>
#include <vector>

#include "exact/frame.h"
#include "exact/propose.h"
#include "exact/star.h"
#include "random.h"
#include "rimline/neighbours.h"

using namespace rimline;
using namespace rimline::exact;

TEST_CASE("corners of many vertices, found in parts, cost what those of each vertex alone cost") {
  Random random(3);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto spacing = local_spacing(points, neighbours);
  const std::vector<Frame> frames = fit_frames(points, neighbours, {});
  const Stars stars = find_stars(points, neighbours, spacing, frames, {});
  const Complex complex = propose_surface(points, frames, stars, spacing, 3, {});
  Kept kept(complex.size());
  for (std::uint8_t& bit : kept) bit = random.uniform() < 0.8;
  std::vector<Index> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  const Corners all(complex, vertices, {});
  std::size_t wrong = 0;
  for (const Index v : vertices) {
    const Corners alone(complex, std::array{v}, {});
    wrong += all.cost(static_cast<std::size_t>(v), kept, {}) != alone.cost(0, kept, {});
  }
  CHECK(wrong == 0);
}
