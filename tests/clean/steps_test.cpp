// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "rimline/clean.h"
#include "rimline/find_boundary.h"
#include "rimline/reconstruct.h"

namespace rimline {
namespace {

// A slope of one in five, a unit between points, that are off their lattice a little.
std::vector<Point> slope(double step) {
  std::vector<Point> points;
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double x = i + 0.4 * random.uniform(), y = j + 0.4 * random.uniform(), z = 0.2 * x;
      points.push_back({x, y, step > 0 ? step * std::round(z / step) : z});
    }
  }
  return points;
}

std::optional<Terraces> terraces_of(const std::vector<Point>& points,
                                    const std::vector<Point>& centres = {}) {
  const Neighbours neighbours = find_neighbours(points, 24, {});
  return find_terraces(points, neighbours, local_spacing(points, neighbours), centres, {});
}

std::optional<Levels> levels_of(const std::vector<double>& values, double spacing) {
  std::vector<Point> points;
  for (const double x : values) points.push_back({x, 0, 0});
  return find_levels(points, &Point::x, spacing);
}

}  // namespace

TEST_CASE("the levels of rounded values are found, with those that are missing; others have none") {
  std::vector<double> values, others;
  Random random(1);
  for (int i = 0; i < 900; ++i) {
    values.push_back(0.5 * std::floor(12 * random.uniform()));
    others.push_back(6 * random.uniform());
  }
  std::erase(values, 1.0);
  const auto levels = levels_of(values, 0.4);
  REQUIRE(levels);
  CHECK(levels->quantum == 0.5);
  CHECK(levels->at.size() == 11);
  CHECK(levels->index.back() == 11);
  CHECK_FALSE(levels_of(others, 0.4));
}

TEST_CASE("terraces are high steps across a surface: no slope, no low step, no lattice has them") {
  const auto found = terraces_of(slope(2));
  REQUIRE(found);
  CHECK(found->axis == 2);
  CHECK(found->levels.quantum == 2);
  CHECK_FALSE(terraces_of(slope(0)));
  CHECK_FALSE(terraces_of(slope(0.5)));
  std::vector<Point> lattice;
  for (int i = 0; i < 900; ++i)
    lattice.push_back({1.0 * (i % 30), 1.0 * (i / 30), 0.01 * (i % 30) * (i % 30)});
  CHECK_FALSE(terraces_of(lattice));
}

TEST_CASE("depths in steps along rays are told where the place of the camera is") {
  auto points = slope(0);
  const Point camera{20, 20, 90};
  for (Point& p : points) {
    const Point ray = p - camera;
    const double depth = norm(ray);
    p = camera + (2 * std::round(depth / 2) / depth) * ray;
  }
  CHECK_FALSE(terraces_of(points, {{5, 0, 70}}));
  const auto found = terraces_of(points, {camera});
  REQUIRE(found);
  CHECK(found->centre == camera);
  CHECK(found->levels.quantum == doctest::Approx(2));
}

TEST_CASE("a slope without its terraces is nearer to the slope, and no point goes farther than a step") {
  const auto truth = slope(0), stepped = slope(2);
  const Neighbours neighbours = find_neighbours(stepped, 24, {});
  const auto smooth =
      without_terraces(stepped, *terraces_of(stepped), local_spacing(stepped, neighbours), {});
  double before = 0, after = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    before += std::abs(stepped[i].z - truth[i].z);
    after += std::abs(smooth[i].z - truth[i].z);
    CHECK(smooth[i].x == stepped[i].x);
    CHECK(std::abs(smooth[i].z - stepped[i].z) <= 2 + 1e-9);
  }
  CHECK(after < 0.5 * before);
}

TEST_CASE("plates at different heights, and a stack of sheets, are no terraces") {
  std::vector<Point> plates, stack;
  for (int i = 0; i < 900; ++i) {
    plates.push_back({1.0 * (i % 30), 1.0 * (i / 30), i % 30 < 15 ? 0.0 : 4.0});
    for (int z = 0; z < 5; ++z)
      stack.push_back({1.0 * (i % 30) + 0.2 * z, 1.0 * (i / 30) + 0.3 * z, 2.5 * z});
  }
  for (const auto& points : {plates, stack}) {
    const auto result = find_boundary(points, preset_options(Preset::Default), {});
    CHECK(result.report.steps.removed == 0);
  }
}

TEST_CASE("rows of a scan are no terraces") {
  std::vector<Point> rows;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 60; ++j) rows.push_back({4.0 * i, 1.0 * j + 0.3 * (i % 2), 0.02 * i * i});
  }
  const auto result = find_boundary(rows, preset_options(Preset::Default), {});
  CHECK(result.report.steps.removed == 0);
  CHECK(result.report.steps.x == 4);
}

TEST_CASE("a slope in steps is one disc of all its points, which stay where they are") {
  const auto points = slope(3);
  const auto result = reconstruct(points, preset_options(Preset::Default), {});
  const Report& report = result.boundary.report;
  CHECK(report.steps.removed == 3);
  CHECK(report.steps.removed_along == "z");
  CHECK(report.steps.z == 3);
  CHECK(report.steps.x == 0);
  CHECK(result.boundary.loops.size() == 1);
  CHECK(report.mesh.points_used == points.size());
  CHECK(report.mesh.euler == 1);
}

}  // namespace rimline
