// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/pipeline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/random.h"
#include "mesh/edges.h"
#include "rimline/arrange.h"
#include "rimline/sample.h"
#include "shapes.h"

namespace rimline {
namespace {

using EdgeSet = std::set<std::pair<Index, Index>>;

EdgeSet loop_edges(const std::vector<Index>& loop) {
  EdgeSet edges;
  for (std::size_t i = 0; i < loop.size(); ++i)
    edges.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  return edges;
}

EdgeSet boundary_edges(const std::vector<Triangle>& triangles) {
  EdgeSet edges;
  for (const Edge& e : edges_of(triangles)) {
    if (e.triangles == 1) edges.insert({e.a, e.b});
  }
  return edges;
}

std::string without_run(const Report& report) {
  auto json = nlohmann::json::parse(to_json(report));
  CHECK(json.contains("run"));
  json.erase("run");
  return json.dump();
}

TEST_CASE("a bumpy disc becomes a disc: all points, V - E + F = 1, its boundary the loop") {
  const auto disc = shapes::disc(16, 0.4);
  for (const Preset preset : {Preset::Paper, Preset::PaperLog}) {
    const ReconstructResult result = reconstruct(disc.points, preset_options(preset), {});
    const MeshSummary& m = result.boundary.report.mesh;
    CHECK(m.euler == 1);
    CHECK(m.boundary_loops == 1);
    CHECK(m.points_used == disc.points.size());
    CHECK(m.nonmanifold_edges == 0);
    CHECK(m.uv_flips == 0);
    CHECK(boundary_edges(result.triangles) == loop_edges(result.boundary.loops[0].points));
    // The paper's band is a few points wide; its loop stays within it.
    for (const Index id : result.boundary.loops[0].points)
      CHECK(norm({disc.points[id].x, disc.points[id].y, 0}) > 0.8);
  }
}

TEST_CASE("triangles face up, or with the normals, and the loop keeps the surface on its left") {
  const auto disc = shapes::disc(16, 0.4);
  const auto signed_area = [&](const std::vector<Index>& loop) {
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      area += cross(disc.points[loop[i]], disc.points[loop[(i + 1) % loop.size()]]).z / 2;
    }
    return area;
  };
  for (const double side : {1.0, -1.0}) {
    Given given;
    given.normals.assign(disc.points.size(), Point{0, 0, side});
    const ReconstructResult result = reconstruct(disc.points, preset_options(Preset::PaperLog), {}, given);
    double facing = 0;
    for (const auto& [a, b, c] : result.triangles) {
      facing += cross(disc.points[b] - disc.points[a], disc.points[c] - disc.points[a]).z;
      const UV p = result.uv[a], q = result.uv[b], r = result.uv[c];
      CHECK((q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u) > 0);
    }
    CHECK(facing * side > 0);
    CHECK(signed_area(result.boundary.loops[0].points) * side > 3);
  }
}

TEST_CASE("one and two threads give the same result and the same report less `run`") {
  const auto disc = shapes::disc(20, 0.5);
  Run one, two;
  one.threads = 1;
  two.threads = 2;
  const auto a = reconstruct(disc.points, preset_options(Preset::PaperLog), one);
  const auto b = reconstruct(disc.points, preset_options(Preset::PaperLog), two);
  CHECK(a.triangles == b.triangles);
  CHECK(a.uv == b.uv);
  CHECK(a.boundary.p_value == b.boundary.p_value);
  CHECK(a.boundary.loops[0].points == b.boundary.loops[0].points);
  CHECK(without_run(a.boundary.report) == without_run(b.boundary.report));
}

TEST_CASE("permuting the input permutes the scores and the loop and nothing else") {
  const auto disc = shapes::disc(14, 0.4);
  std::vector<Index> order(disc.points.size());
  for (Index i = 0; i < static_cast<Index>(order.size()); ++i) order[i] = i;
  Random(11).shuffle(order);
  std::vector<Point> permuted;
  for (const Index i : order) permuted.push_back(disc.points[i]);
  const auto a = find_boundary(disc.points, preset_options(Preset::PaperLog), {});
  const auto b = find_boundary(permuted, preset_options(Preset::PaperLog), {});
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(b.p_value[i] == a.p_value[order[i]]);
  std::vector<Index> loop;
  for (const Index id : b.loops[0].points) loop.push_back(order[id]);
  CHECK(loop == a.loops[0].points);
}

TEST_CASE("points that take no part are counted by reason and used nowhere") {
  auto disc = shapes::disc(14, 0.4);
  const double nan = std::nan("");
  disc.points.push_back(disc.points[3]);
  disc.points.push_back({nan, 0, 0});
  disc.points.push_back({100, 100, 100});
  const auto result = reconstruct(disc.points, preset_options(Preset::PaperLog), {});
  const PointCounts& counts = result.boundary.report.points;
  CHECK(counts.duplicates == 1);
  CHECK(counts.not_finite == 1);
  CHECK(counts.stray == 1);
  CHECK(counts.used + 3 == counts.input);
  for (std::size_t i = disc.points.size() - 3; i < disc.points.size(); ++i) {
    CHECK(std::isnan(result.uv[i].u));
    CHECK(result.boundary.loop[i] == none);
    for (const Triangle& t : result.triangles)
      CHECK(std::count(t.begin(), t.end(), static_cast<Index>(i)) == 0);
  }
}

TEST_CASE("of points that are left out nothing is told, wherever they stand in the input") {
  auto points = shapes::disc(14, 0.4).points;
  const auto at = static_cast<std::ptrdiff_t>(points.size() / 2);
  points.insert(points.begin() + at, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  for (const Preset preset : {Preset::Default, Preset::PaperLog}) {
    const auto found = find_boundary(points, preset_options(preset), {});
    CHECK(std::isnan(found.p_value[at]));
    CHECK(std::isnan(found.score[at]));
    CHECK(found.candidate[at] == 0);
    CHECK(!std::isnan(found.p_value[at + 1]));
    if (preset != Preset::Default) continue;
    CHECK(std::isnan(found.boundary_probability[at]));
    CHECK(found.label[at] == PointLabel::Stray);
  }
}

TEST_CASE("a loop made by hand is used instead of finding one") {
  const auto disc = shapes::disc(12, 0.4);
  Given given;
  given.loops.push_back({disc.rim});
  const auto result = reconstruct(disc.points, preset_options(Preset::Paper), {}, given);
  CHECK(boundary_edges(result.triangles) == loop_edges(disc.rim));
  CHECK(result.boundary.report.search.starts == 0);
}

TEST_CASE("points that a loop made by hand does not bound are left out and named, an error under strict") {
  auto disc = shapes::disc(12, 0.4);
  const std::size_t bounded = disc.points.size();
  for (const Point& p : shapes::disc(6).points) disc.points.push_back(p + Point{50, 0, 0});
  Given given;
  given.loops.push_back({disc.rim});
  Options options = preset_options(Preset::Default);
  const Report report = reconstruct(disc.points, options, {}, given).boundary.report;
  CHECK(report.points.unmeshed == disc.points.size() - bounded);
  REQUIRE(report.left_out.size() == 1);
  CHECK(report.left_out[0].ids.size() == disc.points.size() - bounded);
  CHECK(report.left_out[0].ids.front() == static_cast<Index>(bounded));
  CHECK(report.left_out[0].low.x > 40);
  options.mesh.strict = true;
  try {
    reconstruct(disc.points, options, {}, given);
    FAIL("strict meshed a part of the points");
  } catch (const NoMesh& error) {
    CHECK(error.ids() == report.left_out[0].ids);
    CHECK(error.found.loops.size() == 1);
    CHECK(error.found.report.left_out.size() == 1);
  }
}

TEST_CASE("a surface of which no triangle can be given ends with what was found") {
  std::vector<Point> ring;
  for (int i = 0; i < 60; ++i) ring.push_back({std::cos(i * 0.1047), std::sin(i * 0.1047), 0.3 * i});
  try {
    reconstruct(ring, preset_options(Preset::Default), {});
    FAIL("meshed a spiral");
  } catch (const NoMesh& error) {
    CHECK(exit_status(error.code()) == 3);
    CHECK(error.found.boundary.size() == ring.size());
    CHECK(error.found.report.warnings.back() == error.what());
  }
}

TEST_CASE("bad options and given loops are refused with their names") {
  const auto disc = shapes::disc(12);
  Options options;
  options.boundary.significance = 2;
  try {
    find_boundary(disc.points, options, {});
    FAIL("took a significance of 2");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::BadOption);
    CHECK(std::string(error.what()).find("significance") != std::string::npos);
  }
  Given given;
  given.loops.push_back({{0, 1, 999'999}});
  CHECK_THROWS_AS(find_boundary(disc.points, {}, {}, given), Error);
  given = {};
  given.raster.resize(disc.points.size() - 1);
  CHECK_THROWS_AS(find_boundary(disc.points, {}, {}, given), Error);
}

TEST_CASE("the report tells the least delta, how many are small, and how many points are undersampled") {
  auto points = shapes::disc(14, 0.4).points;
  for (int i = 0; i < 60; ++i)
    points.push_back({1.3 + 0.02 * i, 0.001 * (i % 3), 0});  // a spike: nearly a line
  const auto result = find_boundary(points, preset_options(Preset::PaperLog), {});
  const Arrangement arranged = arrange(points, {});
  const auto scores = score_boundary(arranged.points, find_neighbours(arranged.points, 40, {}), {}, {});
  const Report& report = result.report;
  CHECK(report.assumptions.delta == *std::min_element(scores.delta.begin(), scores.delta.end()));
  CHECK(report.assumptions.delta < 0.05);
  CHECK(report.assumptions.below_delta ==
        std::count_if(scores.delta.begin(), scores.delta.end(), [](float d) { return d < 0.05F; }));
  std::size_t undersampled = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    undersampled += result.candidate[i] == 1 && result.boundary[i] == 0;
  CHECK(undersampled > 0);
  CHECK(report.undersampled == undersampled);
}

TEST_CASE("a loop of the paper has the fitness of its own points, and no probability") {
  const auto disc = shapes::disc(14, 0.4);
  const Options options = preset_options(Preset::PaperLog);
  const auto result = find_boundary(disc.points, options, {});
  double sum = 0;
  for (const Index id : result.loops[0].points) sum += result.score[id];
  const double size = static_cast<double>(result.loops[0].points.size());
  CHECK(result.loops[0].fitness == doctest::Approx(sum / std::pow(size, 0.9)));
  double winner = 0;
  for (std::size_t i = 0; i < disc.points.size(); ++i) winner += result.chromosome[i] * result.score[i];
  const auto bits = static_cast<double>(result.report.search.winner_points);
  CHECK(bits >= size);
  CHECK(result.report.search.winner_fitness == doctest::Approx(winner / std::pow(bits, 0.9)));
  CHECK(std::isnan(result.loops[0].probability));
  CHECK(!std::isnan(find_boundary(disc.points, {}, {}).loops[0].probability));
}

TEST_CASE("the paper's mesh fills every hole but the one that its loop goes round") {
  std::vector<Point> ring;
  for (const Point& p : shapes::disc(20).points) {
    if (norm(p) > 0.4) ring.push_back(p);
  }
  const auto filled = reconstruct(ring, preset_options(Preset::Paper), {}).boundary.report.mesh;
  CHECK(filled.boundary_loops == 1);
  CHECK(filled.euler == 1);
  const auto open = reconstruct(ring, {}, {}).boundary.report.mesh;
  CHECK(open.boundary_loops == 2);
  CHECK(open.euler == 0);
}

TEST_CASE("a warning is given where k / r is below 5") {
  const auto disc = shapes::disc(14);
  Options options = preset_options(Preset::PaperLog);
  CHECK(find_boundary(disc.points, options, {}).report.warnings.empty());
  options.boundary.sectors = 10;
  const Report report = find_boundary(disc.points, options, {}).report;
  CHECK_FALSE(report.assumptions.chi_square_valid);
  CHECK(report.assumptions.points_per_sector == 4);
  CHECK(report.warnings.size() == 1);
}

TEST_CASE(
    "a closed surface is told without a warning, a doubtful gap with its place and the way to take it") {
  SampleOptions sampled;
  sampled.shape = Shape::ClosedSphere;
  sampled.n = 2000;
  const auto sphere = sample(sampled, {});
  const Report closed = find_boundary(sphere.points, {}, {}).report;
  CHECK(closed.closed);
  CHECK(closed.warnings.empty());

  Options strict;
  strict.boundary_loops.min_probability = 1;
  const Report open = find_boundary(shapes::disc(14).points, strict, {}).report;
  CHECK_FALSE(open.closed);
  REQUIRE(open.doubtful.size() == 1);
  CHECK(norm(open.doubtful[0].place) < 0.1);
  REQUIRE(open.warnings.size() == 2);
  CHECK(open.warnings[1].find("--min-probability 0.") != std::string::npos);
}

TEST_CASE("cancelling at the third report of a stage ends there") {
  const auto disc = shapes::disc(20, 0.4);
  std::atomic<bool> stop{false};
  int reports = 0;
  Run run;
  run.stop = &stop;
  run.on_progress = [&](Progress p) {
    if (p.stage == Stage::Loops && ++reports == 3) stop = true;
  };
  CHECK_THROWS_AS(find_boundary(disc.points, preset_options(Preset::Paper), run), Error);
  CHECK(reports == 3);
}

TEST_CASE("a stage that is stopped as it begins ends before the next") {
  const auto disc = shapes::disc(20, 0.4);
  for (const Preset preset : {Preset::Default, Preset::Paper}) {
    std::vector<Stage> stages;  // of a run that nobody stops
    Run run;
    run.on_progress = [&](Progress p) {
      if (stages.empty() || stages.back() != p.stage) stages.push_back(p.stage);
    };
    reconstruct(disc.points, preset_options(preset), run);
    REQUIRE(stages.size() >= 7);
    for (std::size_t last = 0; last < stages.size(); ++last) {
      std::atomic<bool> stop{false};
      std::vector<Stage> begun;
      run.stop = &stop;
      run.on_progress = [&](Progress p) {
        if (begun.empty() || begun.back() != p.stage) begun.push_back(p.stage);
        if (begun.size() == last + 1) stop = true;
      };
      CAPTURE(name(stages[last]));
      CHECK_THROWS_AS(reconstruct(disc.points, preset_options(preset), run), Error);
      CHECK(begun ==
            std::vector<Stage>(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(last) + 1));
    }
  }
}

TEST_CASE("a moved set gives the same loop, also at ten million") {
  const auto disc = shapes::disc(14, 0.4);
  const auto loop = find_boundary(disc.points, preset_options(Preset::PaperLog), {}).loops[0].points;
  for (const double offset : {0.001, 1e7}) {
    std::vector<Point> moved;
    for (const Point& p : disc.points) moved.push_back(p + Point{offset, 2 * offset, -offset});
    CHECK(loop_edges(find_boundary(moved, preset_options(Preset::PaperLog), {}).loops[0].points) ==
          loop_edges(loop));
  }
}

}  // namespace
}  // namespace rimline
