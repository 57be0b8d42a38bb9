// SPDX-License-Identifier: GPL-3.0-or-later
// The unit of the input is nobody's business: the same surface in any unit has the same loops, mesh and map.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "rimline/pipeline.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

std::vector<Point> surface(Shape shape) {
  SampleOptions options;
  options.shape = shape;
  options.sampling = Sampling::Random;
  options.n = 1500;
  return sample(options, Run{}).points;
}

std::vector<Point> times(std::vector<Point> points, double factor) {
  for (Point& p : points) p = factor * p;
  return points;
}

std::vector<std::vector<Index>> ids_of(const std::vector<Loop>& loops) {
  std::vector<std::vector<Index>> ids;
  for (const Loop& loop : loops) ids.push_back(loop.points);
  return ids;
}

// The largest difference of two maps whose second is `factor` as large; infinite where only one is finite.
double map_difference(const std::vector<UV>& a, const std::vector<UV>& b, double factor) {
  double most = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isnan(a[i].u) && std::isnan(b[i].u)) continue;  // on a seam
    const double du = std::abs(a[i].u - b[i].u / factor), dv = std::abs(a[i].v - b[i].v / factor);
    if (!std::isfinite(du + dv)) return std::numeric_limits<double>::infinity();
    most = std::max({most, du, dv});
  }
  return most;
}

void check_same(const ReconstructResult& one, const ReconstructResult& other, double factor,
                double map_factor, double tolerance) {
  CHECK(ids_of(other.boundary.loops) == ids_of(one.boundary.loops));
  CHECK(other.triangles == one.triangles);
  CHECK(other.patch == one.patch);
  CHECK(map_difference(one.uv, other.uv, map_factor) <= tolerance);
  CHECK(other.seams.corners == one.seams.corners);
  CHECK(map_difference(one.seams.uv, other.seams.uv, map_factor) <= tolerance);
  for (std::size_t i = 0; i < one.boundary.loops.size(); ++i) {
    CHECK(other.boundary.loops[i].length / factor == doctest::Approx(one.boundary.loops[i].length));
    CHECK(other.boundary.report.loops[i].length == other.boundary.loops[i].length);
  }
  CHECK(other.boundary.report.spacing.mean / factor == doctest::Approx(one.boundary.report.spacing.mean));
  CHECK(other.boundary.report.mesh.edges == one.boundary.report.mesh.edges);
  CHECK(other.boundary.report.mesh.min_angle_histogram == one.boundary.report.mesh.min_angle_histogram);
}

TEST_CASE("a unit from 1e-300 to 1e300 changes neither loops nor triangles nor the map") {
  const std::vector<Point> points = surface(Shape::Pipe);
  for (const Domain domain : {Domain::Disc, Domain::Free}) {
    Options options = preset_options(Preset::Default);
    options.map.domain = domain;
    const ReconstructResult one = reconstruct(points, options, Run{});
    for (const double factor :
         {1e-300, 1e-154, 1e-80, 1e-20, 1e-9, 1e-3, 1e3, 1e9, 1e20, 1e80, 1e154, 1e300}) {
      CAPTURE(factor);
      const ReconstructResult other = reconstruct(times(points, factor), options, Run{});
      // A decimal factor rounds the coordinates, so the map is the same to rounding.
      check_same(one, other, factor, domain == Domain::Free ? factor : 1, 1e-6);
      CHECK(nlohmann::json::accept(to_json(other.boundary.report)));
    }
  }
}

TEST_CASE("a unit that is a power of two changes no bit, under every preset") {
  const std::vector<Point> points = surface(Shape::SphereMinusCap);
  for (const Preset preset : {Preset::Default, Preset::Paper, Preset::PaperLog}) {
    const Options options = preset_options(preset);
    const ReconstructResult one = reconstruct(points, options, Run{});
    for (const int exponent : {-900, -500, -120, -33, -31, -7, 7, 31, 33, 120, 500, 900}) {
      CAPTURE(exponent);
      const double factor = std::ldexp(1.0, exponent);
      const ReconstructResult other = reconstruct(times(points, factor), options, Run{});
      check_same(one, other, factor, 1, 0);
      CHECK(other.boundary.p_value == one.boundary.p_value);
      CHECK(other.boundary.score == one.boundary.score);
      CHECK(other.boundary.boundary_probability == one.boundary.boundary_probability);
      CHECK(other.boundary.loops.at(0).length == factor * one.boundary.loops.at(0).length);
    }
  }
}

TEST_CASE("lengths that are given and lengths that are told are in the unit of the input, at any scale") {
  const std::vector<Point> points = surface(Shape::SquareWithHoles);
  Options options = preset_options(Preset::Default);
  const ReconstructResult open = reconstruct(points, options, Run{});
  const double limit = 1.001 * open.boundary.loops.back().length;  // the shortest
  options.mesh.holes = {.fill = true, .most_length = limit};
  options.mesh.fill_points = true;
  Given given;
  given.reference = {"itself", points, open.triangles};
  const ReconstructResult one = reconstruct(points, options, Run{}, given);
  REQUIRE(!one.boundary.report.holes->filled.empty());
  REQUIRE(one.boundary.report.holes->kept > 0);
  for (const int exponent : {-400, 400}) {
    CAPTURE(exponent);
    const double factor = std::ldexp(1.0, exponent);
    options.mesh.holes.most_length = factor * limit;
    Given scaled = given;
    scaled.reference.points = times(points, factor);
    const ReconstructResult other = reconstruct(times(points, factor), options, Run{}, scaled);
    check_same(one, other, factor, 1, 0);
    CHECK(other.added == times(one.added, factor));
    const Report &a = one.boundary.report, &b = other.boundary.report;
    CHECK(b.options.mesh.holes == options.mesh.holes);
    REQUIRE(b.holes->filled.size() == a.holes->filled.size());
    CHECK(b.holes->kept == a.holes->kept);
    CHECK(b.holes->filled[0].length == factor * a.holes->filled[0].length);
    CHECK(b.reference->hausdorff == factor * a.reference->hausdorff);
    CHECK(b.reference->to_reference.mean == factor * a.reference->to_reference.mean);
    CHECK(b.reference->from_reference.rms == factor * a.reference->from_reference.rms);
    CHECK(b.reference->edges_agree == a.reference->edges_agree);
    CHECK(b.mesh.area == factor * (factor * a.mesh.area));
  }
}

}  // namespace
}  // namespace rimline
