// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/map_by_charts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "grids.h"
#include "map/angle_error.h"
#include "map/conformal_scale.h"
#include "map/embed.h"
#include "map/free_map.h"
#include "map/outline_first.h"
#include "mesh/corner_angles.h"
#include "rimline/measure.h"

namespace rimline {
namespace {

double area_of_corners(const ChartedMap& map, std::size_t t) {
  const UV a = map.uv[map.corners[t][0]], b = map.uv[map.corners[t][1]], c = map.uv[map.corners[t][2]];
  return 0.5 * ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
}

// No triangle is turned, every corner is at a place of its vertex, charts share no place, and their numbers
// run from 0 without gaps.
void check_map(const ChartedMap& map, const shapes::Mesh& mesh) {
  REQUIRE(map.kind == Domain::Free);
  REQUIRE(map.corners.size() == mesh.triangles.size());
  std::vector<Index> chart_of(map.uv.size(), none);
  std::set<Index> charts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    if (map.turned[t]) std::swap(corners[1], corners[2]);
    CHECK(area_of_corners(map, t) > 0);
    for (int c = 0; c < 3; ++c) {
      const Index place = map.corners[t][c];
      CHECK(map.vertex[place] == corners[c]);
      CHECK((chart_of[place] == none || chart_of[place] == map.chart[t]));
      chart_of[place] = map.chart[t];
    }
    charts.insert(map.chart[t]);
  }
  CHECK(charts.size() == map.charts);
  CHECK(*charts.begin() == 0);
  CHECK(*charts.rbegin() == static_cast<Index>(map.charts) - 1);
}

// As the pipeline measures it, by corners.
DistortionSummary distortion_of(const ChartedMap& map, const shapes::Mesh& mesh) {
  std::vector<Point> points;
  for (const Index v : map.vertex) points.push_back(mesh.points[v]);
  return measure_distortion(points, map.corners, map.uv, {}, 1, {}).whole;
}

// The triangles of a ball of radius 1 whose middles are above a height.
shapes::Mesh ball_above(double height) {
  const shapes::Mesh ball = shapes::octahedron(4);
  std::vector<Index> number(ball.points.size(), none);
  shapes::Mesh part;
  for (Triangle t : ball.triangles) {
    if (ball.points[t[0]].z + ball.points[t[1]].z + ball.points[t[2]].z < 3 * height) continue;
    for (Index& v : t) {
      if (number[v] == none) {
        number[v] = static_cast<Index>(part.points.size());
        part.points.push_back(ball.points[v]);
      }
      v = number[v];
    }
    part.triangles.push_back(t);
  }
  return part;
}

// A square of n x n cells, its heights at random, up to so many cells.
shapes::Mesh crumpled(int n, double height) {
  std::mt19937 random(7);
  shapes::Mesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i)
      mesh.points.push_back({1.0 * i, 1.0 * j, height * static_cast<double>(random()) / 4294967296.0});
  }
  mesh.triangles = shapes::cells(n, n, [=](int i, int j) { return static_cast<Index>(i + (n + 1) * j); });
  return mesh;
}

double corner_error(const ChartedMap& map, const shapes::Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : map.corners) {
    const auto space = [&](int c) { return mesh.points[map.vertex[t[c]]]; };
    const auto flat = [&](int c) { return Point{map.uv[t[c]].u, map.uv[t[c]].v, 0}; };
    const auto a = corner_angles(space(0), space(1), space(2)), b = corner_angles(flat(0), flat(1), flat(2));
    for (int c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]);
  }
  return sum / (3 * static_cast<double>(map.corners.size()));
}

}  // namespace

TEST_CASE("surfaces of any topology get maps without turned triangles, their stretch within bounds") {
  for (const shapes::Mesh& mesh : {shapes::octahedron(4), shapes::torus(48, 16, 3, 1), shapes::tube(16, 30),
                                   shapes::moebius(60, 6), shapes::dumbbell(24, 60)}) {
    CAPTURE(mesh.points.size());
    const ChartedMap map = map_by_charts(mesh.points, mesh.triangles, {}, {});
    check_map(map, mesh);
    CHECK(map.seams > 0);
    CHECK(map.charts <= 3);
    const DistortionSummary distortion = distortion_of(map, mesh);
    CHECK(distortion.stretch_l2 <= 2);
    CHECK(distortion.stretch_linf <= 100);
  }
}

TEST_CASE("a ball is two charts at its natural choice, one where one is asked for, and seven of seven") {
  const shapes::Mesh ball = shapes::octahedron(4);
  const ChartedMap map = map_by_charts(ball.points, ball.triangles, {}, {});
  CHECK(map.charts == 2);
  CHECK(map.seams < 1.35 * 2 * std::numbers::pi);  // the equator, along edges
  const ChartedMap one = map_by_charts(ball.points, ball.triangles, {.charts = 1}, {});
  if (one.kind == Domain::Free) check_map(one, ball);
  CHECK(one.charts == 1);
  const ChartedMap seven = map_by_charts(ball.points, ball.triangles, {.charts = 7}, {});
  check_map(seven, ball);
  CHECK(seven.charts == 7);
}

TEST_CASE("a tube is opened lengthwise and laid flat: all angles and areas are kept") {
  const shapes::Mesh tube = shapes::tube(16, 40);
  const ChartedMap map = map_by_charts(tube.points, tube.triangles, {}, {});
  check_map(map, tube);
  CHECK(map.charts == 1);
  const DistortionSummary distortion = distortion_of(map, tube);
  CHECK(distortion.angle_mean < 1e-4);
  CHECK(distortion.stretch_linf < 1.001);
  // As long as the tube, up to the slant of edges.
  const double length = 39 * 2 * std::numbers::pi / 16;
  CHECK(map.seams > 0.99 * length);
  CHECK(map.seams < 1.5 * length);
}

TEST_CASE("a chart that is a disc keeps one place a vertex, in the order of its vertices") {
  const shapes::Mesh disc = ball_above(0.1);
  const ChartedMap map = map_by_charts(disc.points, disc.triangles, {}, {});
  check_map(map, disc);
  CHECK(map.charts == 1);
  CHECK(map.seams == 0);
  CHECK(map.corners == disc.triangles);
  CHECK(distortion_of(map, disc).angle_mean < 0.03);
}

TEST_CASE("angles of a free map are kept no worse than in the disc's, in one chart and in many") {
  const shapes::Mesh cap = ball_above(-0.6);
  const shapes::Mesh vase = shapes::revolved(
      40, 50, [](int j) { return 1 + 0.7 * std::sin(0.2 * j); }, [](int j) { return 0.08 * j; });
  for (const shapes::Mesh& mesh : {cap, vase, crumpled(24, 0.8), crumpled(24, 2.0)}) {
    const AngleError disc = error_of_disc(open_surface(mesh.points, mesh.triangles), 1e-10, {});
    for (const int charts : {0, 1}) {
      CAPTURE(mesh.points.size());
      CAPTURE(charts);
      const ChartedMap map = map_by_charts(mesh.points, mesh.triangles, {.charts = charts}, {});
      REQUIRE(map.charts > 0);
      CHECK(corner_error(map, mesh) <= disc.corner + 1e-9);
      if (charts == 1 && map.kind == Domain::Disc)
        CHECK(corner_error(map, mesh) == doctest::Approx(disc.corner));
    }
  }
}

TEST_CASE(
    "what is crumpled, so that least squares turn triangles, is one chart within the bounds all the same") {
  const shapes::Mesh mesh = crumpled(24, 5);
  const OpenMesh open = open_surface(mesh.points, mesh.triangles);
  std::vector<UV> uv;
  free_map(open.points, open.mesh, open.loops.front().points, 0, uv, {});
  REQUIRE_FALSE(flipped_triangles(open.mesh.triangles, uv, {}).empty());
  const ChartedMap map = map_by_charts(mesh.points, mesh.triangles, {}, {});
  check_map(map, mesh);
  CHECK(map.charts == 1);
  const DistortionSummary distortion = distortion_of(map, mesh);
  CHECK(distortion.stretch_l2 <= 2);
  CHECK(distortion.stretch_linf <= 100);
}

TEST_CASE("a needle is cut open to its tip and unrolled") {
  constexpr int about = 12, rings = 60;
  shapes::Mesh needle = shapes::revolved(
      about, rings, [](int j) { return 1 - j / double{rings}; }, [](int j) { return 0.5 * j; });
  const auto tip = static_cast<Index>(needle.points.size());
  needle.points.push_back({0, 0, 0.5 * rings});
  for (Index i = 0; i < about; ++i)
    needle.triangles.push_back({about * (rings - 1) + i, about * (rings - 1) + (i + 1) % about, tip});
  const ChartedMap map = map_by_charts(needle.points, needle.triangles, {}, {});
  check_map(map, needle);
  CHECK(map.charts <= 2);
  CHECK(distortion_of(map, needle).angle_mean < 0.03);
}

TEST_CASE("maps are the same for any number of threads") {
  const shapes::Mesh mesh = shapes::dumbbell(24, 60);
  Run one, many;
  one.threads = 1, many.threads = 7;
  const ChartedMap a = map_by_charts(mesh.points, mesh.triangles, {}, one);
  const ChartedMap b = map_by_charts(mesh.points, mesh.triangles, {}, many);
  CHECK(a.corners == b.corners);
  CHECK(a.chart == b.chart);
  CHECK(std::ranges::equal(a.uv, b.uv));
}

TEST_CASE("the outline of a conformal map turns once round, and that of a flat square is the square") {
  shapes::Mesh sheet;
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) sheet.points.push_back({0.1 * i, 0.1 * j, 0});
  }
  sheet.triangles = shapes::cells(10, 10, [](int i, int j) { return static_cast<Index>(i + 11 * j); });
  const OpenMesh open = open_surface(sheet.points, sheet.triangles);
  std::vector<double> turning;
  const std::vector<double> scale = conformal_log_scale(open, 1e-12, turning, {});
  double sum = 0;
  for (const double angle : turning) sum += angle;
  CHECK(sum == doctest::Approx(2 * std::numbers::pi));
  CHECK(*std::ranges::max_element(scale) == doctest::Approx(0).epsilon(1e-9));
  CHECK(stretch_of_scale(open, scale).mean == doctest::Approx(1));
  std::vector<UV> uv;
  map_outline_first(open, turning, 1e-12, uv, {});
  const Stretch stretch = stretch_of_map(open, uv);
  CHECK(stretch.mean == doctest::Approx(1));
  CHECK(stretch.worst == doctest::Approx(1));
}

TEST_CASE("a sphere without a small cap would shrink as a stereographic map does") {
  // From the pole opposite to the hole, the scale is 1 / cos^2(angle / 2) up to a factor.
  const double edge = 2.6;
  const shapes::Mesh cap = ball_above(std::cos(edge));
  const OpenMesh open = open_surface(cap.points, cap.triangles);
  std::vector<double> turning;
  const std::vector<double> scale = conformal_log_scale(open, 1e-12, turning, {});
  const double expected = -2 * std::log(std::cos(edge / 2));
  CHECK(-*std::ranges::min_element(scale) == doctest::Approx(expected).epsilon(0.05));
}

}  // namespace rimline
