// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "rimline/sample.h"

using namespace rimline;
using namespace rimline::exact;

namespace {

Sample disc(Sampling sampling, double noise) {
  SampleOptions options;
  options.shape = Shape::FlatDisc;
  options.sampling = sampling;
  options.n = 3000;
  options.noise = noise;
  return sample(options, {});
}

// Starts from the true loop, whatever the noise; the disc lies in z = 0 and its loop runs counter-clockwise.
Redrawn redraw_true(const Sample& sample, const Blur& blur) {
  const Neighbours neighbours = find_neighbours(sample.points, 40, {});
  const std::vector<Index>& rim = sample.loops[0].points;
  return redraw(sample.points, neighbours, local_spacing(neighbours), rim,
                std::vector<Point>(rim.size(), Point{0, 0, 1}), blur);
}

double f1(const std::vector<Index>& found, const std::vector<std::uint8_t>& truth) {
  const double hits = std::count_if(found.begin(), found.end(), [&](Index i) { return truth[i] == 1; });
  const double all = std::count(truth.begin(), truth.end(), 1);
  return 2 * hits / (static_cast<double>(found.size()) + all);
}

}  // namespace

TEST_CASE("on clean even points the loop drawn anew is the loop as it was") {
  const Sample clean = disc(Sampling::BlueNoise, 0);
  const Redrawn drawn = redraw_true(clean, {});
  const auto start = std::find(drawn.loop.begin(), drawn.loop.end(), clean.loops[0].points[0]);
  REQUIRE(start != drawn.loop.end());
  std::vector<Index> turned(start, drawn.loop.end());
  turned.insert(turned.end(), drawn.loop.begin(), start);
  CHECK(turned == clean.loops[0].points);
}

TEST_CASE("the loop is simple, outermost, and named with the points around it") {
  const Sample noisy = disc(Sampling::BlueNoise, 0.5);
  const Redrawn drawn = redraw_true(noisy, {.noise = 0.35});
  const std::set<Index> on(drawn.loop.begin(), drawn.loop.end());
  CHECK(on.size() == drawn.loop.size());
  REQUIRE(drawn.near.size() == drawn.depth.size());
  for (std::size_t i = 0; i < drawn.near.size(); ++i)
    CHECK((drawn.depth[i] > 0) == on.contains(drawn.near[i]));
  CHECK(std::is_sorted(drawn.depth.rbegin(), drawn.depth.rend()));
}

TEST_CASE("under noise as many points are on the loop as there were, most of them the true ones") {
  for (const auto& [noise, level, least] : {std::tuple(0.2, 0.15, 0.96), std::tuple(0.5, 0.35, 0.78)}) {
    const Sample noisy = disc(Sampling::BlueNoise, noise);
    const Redrawn drawn = redraw_true(noisy, {.noise = level});
    const auto truth = static_cast<double>(noisy.loops[0].points.size());
    CHECK(static_cast<double>(drawn.loop.size()) == doctest::Approx(truth).epsilon(0.06));
    CHECK(f1(drawn.loop, noisy.boundary) >= least);
  }
}

TEST_CASE(
    "of random points those within half a spacing may be on the boundary, and the loop leaves them out") {
  const Sample strewn = disc(Sampling::Random, 0);
  const Redrawn drawn = redraw_true(strewn, {.irregular = 1});
  std::vector<Index> may_be;
  for (std::size_t i = 0; i < drawn.near.size(); ++i) {
    if (drawn.depth[i] > 0) may_be.push_back(drawn.near[i]);
  }
  CHECK(f1(may_be, strewn.near_boundary) >= 0.94);
  CHECK(f1(drawn.loop, strewn.near_boundary) < 0.9);
  CHECK(f1(drawn.loop, strewn.boundary) >= 0.85);
}

TEST_CASE("a rim of a few points is left alone") {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Neighbours neighbours = find_neighbours(points, 3, {});
  CHECK(redraw(points, neighbours, local_spacing(neighbours), {0, 1, 2, 3},
               std::vector<Point>(4, Point{0, 0, 1}), {.noise = 0.3})
            .loop.empty());
}
