// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.h"
#include "rimline/arrange.h"
#include "rimline/clean.h"
#include "rimline/reconstruct.h"
#include "rimline/sample.h"
#include "shapes.h"

namespace rimline {
namespace {

// Of points as they are, by their places in the list given.
StrayPoints stray_of(const std::vector<Point>& points) {
  const Arrangement a = arrange(points, {});
  const Neighbours neighbours = find_neighbours(a.points, 40, {});
  StrayPoints stray = find_stray_points(a.points, neighbours, local_spacing(a.points, neighbours), {});
  for (auto* list : {&stray.off_surface, &stray.on_line, &stray.apart}) {
    for (Index& i : *list) i = a.ids[i];
    std::ranges::sort(*list);
  }
  return stray;
}

std::vector<Point> sampled(Shape shape, Sampling sampling, double noise = 0) {
  SampleOptions options;
  options.shape = shape;
  options.n = 1500;
  options.sampling = sampling;
  options.noise = noise;
  return sample(options, {.seed = 3}).points;
}

// In a box around a wavy saddle.
Point in_box(Random& random) {
  const auto one = [&](double size) { return size * (2 * random.uniform() - 1); };
  const double x = one(1.2), y = one(1.2);
  return {x, y, one(0.6)};
}

std::vector<Index> added_ids(std::size_t first, std::size_t end) {
  std::vector<Index> ids;
  for (std::size_t i = first; i < end; ++i) ids.push_back(static_cast<Index>(i));
  return ids;
}

// Triangles as sets of corners, of the points before `first` alone.
std::set<std::set<Index>> triangles_before(const std::vector<Triangle>& triangles, std::size_t first) {
  std::set<std::set<Index>> found;
  for (const Triangle& t : triangles) {
    if (std::ranges::all_of(t, [&](Index v) { return static_cast<std::size_t>(v) < first; }))
      found.insert({t[0], t[1], t[2]});
  }
  return found;
}

constexpr double disc_spacing = 0.072;  // of shapes::disc(14)

}  // namespace

TEST_CASE("a clean surface has no stray point, however it was sampled") {
  for (const Shape shape :
       {Shape::FlatDisc, Shape::BumpySquare, Shape::Pipe, Shape::SquareWithHoles, Shape::HemisphereCap}) {
    for (const Sampling sampling :
         {Sampling::BlueNoise, Sampling::Random, Sampling::Grid, Sampling::ScanLines, Sampling::SmoothDensity,
          Sampling::DensityStep, Sampling::Cropped}) {
      for (const double noise : {0.0, 0.2}) {
        CAPTURE(static_cast<int>(shape));
        CAPTURE(static_cast<int>(sampling));
        CAPTURE(noise);
        CHECK(all_of(stray_of(sampled(shape, sampling, noise))).size() <= 1);
      }
    }
  }
}

TEST_CASE("points over a surface are off it, at any distance, and nothing else is") {
  for (const double height : {0.5, 1.0, 2.0, 5.0, 50.0}) {
    auto points = shapes::disc(14, 0.3).points;
    const std::size_t first = points.size();
    points.push_back({0.31, 0.17, 0.3 + height * disc_spacing});
    points.push_back({-0.42, 0.2, 0.2 - height * disc_spacing});
    CAPTURE(height);
    CHECK(all_of(stray_of(points)) == added_ids(first, points.size()));
  }
}

TEST_CASE("a tail that leads away from the rim, and a line that stands on the surface, are stray") {
  auto points = shapes::disc(14, 0.1).points;
  const std::size_t first = points.size();
  for (int i = 2; i < 8; ++i) points.push_back({1 + i * disc_spacing, 0.01, 0});
  for (int i = 1; i < 40; ++i) points.push_back({-0.3, 0.2, 0.1 + 0.9 * i * disc_spacing});
  const StrayPoints stray = stray_of(points);
  CHECK(all_of(stray) == added_ids(first, points.size()));
  CHECK(stray.on_line.size() > 35);
}

TEST_CASE("twenty points far off are apart; a hundred are a part of the surface") {
  for (const double far : {3.0, 100.0, 1e9}) {
    auto points = shapes::disc(20).points;
    const std::size_t first = points.size();
    for (int i = 0; i < 20; ++i) points.push_back({far + 0.05 * (i % 5), 0.05 * (i / 5), 0});
    CAPTURE(far);
    CHECK(stray_of(points).apart == added_ids(first, points.size()));
    points.resize(first);
    for (int i = 0; i < 100; ++i) points.push_back({far + 0.05 * (i % 10), 0.05 * (i / 10), 0});
    CHECK(stray_of(points).empty());
  }
}

TEST_CASE("a strip two points wide, rows far apart, a dense rim, and a second sheet are no dirt") {
  std::vector<Point> strip, rows, sheets;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 2; ++j) strip.push_back({i + 0.5 * j, 0.87 * j, 0});
    for (int j = 0; j < 12; ++j) rows.push_back({1.0 * i, 6.0 * j, 0.01 * j * j});
  }
  for (int i = 0; i < 900; ++i) {
    for (int z = 0; z < 2; ++z) sheets.push_back({1.0 * (i % 30), 1.0 * (i / 30), 1.6 * z});
  }
  auto dense = shapes::disc(14).points;
  for (int i = 0; i < 800; ++i)
    dense.push_back({1.05 * std::cos(i * 0.00785), 1.05 * std::sin(i * 0.00785), 0});
  for (const auto* points : {&strip, &rows, &sheets, &dense}) CHECK(stray_of(*points).empty());
}

TEST_CASE("outliers that are one another's neighbours are found; a coarse part of a surface is none") {
  const auto clean = sampled(Shape::WavySaddle, Sampling::BlueNoise);
  auto points = clean;
  Random random(9);
  for (int i = 0; i < 75; ++i) points.push_back(8.0 * in_box(random) + Point{0, 0, 6});
  const auto result = reconstruct(points, preset_options(Preset::Default), {});
  CHECK(result.boundary.report.points.stray == 75);
  CHECK(result.triangles == reconstruct(clean, preset_options(Preset::Default), {}).triangles);
  std::vector<Point> graded;  // a plane whose spacing changes sixfold at a line
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) graded.push_back({1.0 * i, 1.0 * j + 0.5 * (i % 2), 0});
  }
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 10; ++j) graded.push_back({63.0 + 6 * i, 6.0 * j + 3 * (i % 2), 0});
  }
  CHECK(stray_of(graded).empty());
}

TEST_CASE("moving, scaling and permuting the points changes nothing") {
  auto points = sampled(Shape::WavySaddle, Sampling::BlueNoise);
  Random random(5);
  for (int i = 0; i < 40; ++i) points.push_back(in_box(random));
  const std::vector<Index> expected = all_of(stray_of(points));
  CHECK(expected.size() > 15);  // of a first round, which leaves others to the next
  std::vector<Point> other(points.rbegin(), points.rend());
  for (Point& p : other) p = 8.0 * p + Point{64, -32, 128};
  std::vector<Index> found = all_of(stray_of(other));
  for (Index& i : found) i = static_cast<Index>(points.size()) - 1 - i;
  std::ranges::sort(found);
  CHECK(found == expected);
}

TEST_CASE("outliers in the box change neither loop nor mesh of the surface") {
  const auto clean = sampled(Shape::WavySaddle, Sampling::BlueNoise);
  const Options options = preset_options(Preset::Default);
  const auto expected = reconstruct(clean, options, {});
  const auto wanted = triangles_before(expected.triangles, clean.size());
  for (const int count : {8, 30, 75}) {
    auto points = clean;
    Random random(static_cast<std::uint64_t>(count));
    while (points.size() < clean.size() + static_cast<std::size_t>(count)) {
      const Point p = in_box(random);  // none so near that it can not be told
      if (std::ranges::all_of(clean, [&](Point q) { return distance(p, q) > 0.2; })) points.push_back(p);
    }
    CAPTURE(count);
    const std::vector<Index> stray = all_of(stray_of(points));
    CHECK(std::ranges::none_of(stray, [&](Index i) { return static_cast<std::size_t>(i) < clean.size(); }));
    const auto result = reconstruct(points, options, {});
    CHECK(result.boundary.report.points.stray == static_cast<std::size_t>(count));
    CHECK(triangles_before(result.triangles, clean.size()) == wanted);
    REQUIRE(result.boundary.loops.size() == expected.boundary.loops.size());
    const auto as_set = [](const Loop& loop) {
      return std::set<Index>(loop.points.begin(), loop.points.end());
    };
    CHECK(as_set(result.boundary.loops[0]) == as_set(expected.boundary.loops[0]));
  }
}

}  // namespace rimline
