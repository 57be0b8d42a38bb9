// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/smooth_loop.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "rimline/sample.h"

using namespace rimline;

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
SmoothedLoop redraw_true(const Sample& sample, const NoiseModel& noise_model) {
  const Neighbours neighbours = find_neighbours(sample.points, 40, {});
  const std::vector<Index>& rim = sample.loops[0].points;
  return smooth_loop(sample.points, neighbours, local_spacing(sample.points, neighbours), rim,
                     std::vector<Point>(rim.size(), Point{0, 0, 1}), noise_model);
}

double f1(const std::vector<Index>& found, const std::vector<std::uint8_t>& truth) {
  const double hits = std::count_if(found.begin(), found.end(), [&](Index i) { return truth[i] == 1; });
  const double all = std::count(truth.begin(), truth.end(), 1);
  return 2 * hits / (static_cast<double>(found.size()) + all);
}

}  // namespace

TEST_CASE("on clean even points the loop drawn anew is the loop as it was") {
  const Sample clean = disc(Sampling::BlueNoise, 0);
  const SmoothedLoop drawn = redraw_true(clean, {});
  const auto start = std::find(drawn.loop.begin(), drawn.loop.end(), clean.loops[0].points[0]);
  REQUIRE(start != drawn.loop.end());
  std::vector<Index> turned(start, drawn.loop.end());
  turned.insert(turned.end(), drawn.loop.begin(), start);
  CHECK(turned == clean.loops[0].points);
}

TEST_CASE("the loop is simple, holds the outermost points, and is named with those around it") {
  const Sample noisy = disc(Sampling::BlueNoise, 0.5);
  const SmoothedLoop drawn = redraw_true(noisy, {.noise = 0.35});
  const std::set<Index> on(drawn.loop.begin(), drawn.loop.end());
  CHECK(on.size() == drawn.loop.size());
  REQUIRE(drawn.near.size() == drawn.depth.size());
  const std::set<Index> near(drawn.near.begin(), drawn.near.end());
  CHECK(std::includes(near.begin(), near.end(), on.begin(), on.end()));
  for (std::size_t i = 0; i < drawn.near.size(); ++i) {
    if (drawn.depth[i] > 1) CHECK(on.contains(drawn.near[i]));
    if (drawn.depth[i] < -1) CHECK_FALSE(on.contains(drawn.near[i]));
  }
  CHECK(std::is_sorted(drawn.depth.rbegin(), drawn.depth.rend()));
}

TEST_CASE("under noise as many points are on the loop as there were, most of them the true ones") {
  for (const auto& [noise, level, least] : {std::tuple(0.2, 0.15, 0.98), std::tuple(0.5, 0.35, 0.83)}) {
    const Sample noisy = disc(Sampling::BlueNoise, noise);
    const SmoothedLoop drawn = redraw_true(noisy, {.noise = level});
    const auto truth = static_cast<double>(noisy.loops[0].points.size());
    CHECK(static_cast<double>(drawn.loop.size()) == doctest::Approx(truth).epsilon(0.06));
    CHECK(f1(drawn.loop, noisy.boundary) >= least);
  }
}

TEST_CASE(
    "a point of the rim that noise moved inwards is not passed over for one that came out from behind") {
  // A tube of rows, the rim at z = 0. One point of the rim lies 0.45 behind it, and one of the
  // second row, elsewhere, 0.35: it is the outermost but one, but there the rim is full.
  std::vector<Point> points;
  std::vector<Index> rim;
  constexpr int around = 60, rows = 6, moved_in = 20, moved_out = 40;
  constexpr double radius = around / (2 * std::numbers::pi);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const double in = row == 0 && i == moved_in ? 0.45 : row == 1 && i == moved_out ? 0.35 : 0.985 * row;
      const double angle = 2 * std::numbers::pi * (i + (row == 1 && i == moved_out ? 0.5 : 0.0)) / around;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), in});
      if (row == 0) rim.push_back(static_cast<Index>(points.size() - 1));
    }
  }
  std::vector<Point> normals;
  for (const Index v : rim) normals.push_back({points[v].x / radius, points[v].y / radius, 0});
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const SmoothedLoop drawn =
      smooth_loop(points, neighbours, local_spacing(points, neighbours), rim, normals, {.noise = 0.25});
  const std::set<Index> on(drawn.loop.begin(), drawn.loop.end());
  CHECK(on == std::set<Index>(rim.begin(), rim.end()));
}

TEST_CASE(
    "of random points those within half a spacing may be on the boundary, and the loop leaves them out") {
  const Sample strewn = disc(Sampling::Random, 0);
  const SmoothedLoop drawn = redraw_true(strewn, {.irregular = 1});
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
  CHECK(smooth_loop(points, neighbours, local_spacing(points, neighbours), {0, 1, 2, 3},
                    std::vector<Point>(4, Point{0, 0, 1}), {.noise = 0.3})
            .loop.empty());
}
