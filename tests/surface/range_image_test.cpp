// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/range_image.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "rimline/delaunay.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

constexpr int columns = 30, rows = 20;

// Samples (x, y) of a scanner that looks along z, and how deep each is; then turned about all axes, so that
// nothing is along one.
template <class Depth>
std::vector<Point> scan(const Depth& depth) {
  std::vector<Point> points;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) points.push_back({double(x), double(y), depth(x, y)});
  }
  return points;
}

Point turned(Point p) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Point q{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  return {q.x, c * q.y - s * q.z, s * q.y + c * q.z};
}

std::vector<Point> turned(std::vector<Point> points) {
  for (Point& p : points) p = turned(p);
  return points;
}

double bowl(int x, int y) { return 0.05 * (x - 12) * (x - 12) + 0.1 * (y - 9) * (y - 9); }

std::optional<RangeImage> find(Points points) {
  return find_range_image(points, find_neighbours(points, 40, {}), {});
}

std::vector<Triangle> surface(Points points) {
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto raster = find_range_image(points, neighbours, {});
  REQUIRE(raster.has_value());
  return range_image_triangles(points, fit_frames(points, neighbours, {}), *raster).triangles();
}

TEST_CASE("a curved surface scanned on a raster shows its view and step") {
  const auto points = turned(scan(bowl));
  const auto raster = find(points);
  REQUIRE(raster.has_value());
  CHECK(raster->step == doctest::Approx(1).epsilon(1e-3));
  CHECK(std::abs(dot(raster->view, turned({0, 0, 1}))) == doctest::Approx(1).epsilon(1e-5));
  CHECK(surface(points).size() == 2 * (columns - 1) * (rows - 1));
}

TEST_CASE("a nearly flat lattice is seen in full, and a plane needs no view") {
  const auto wavy = turned(scan([](int x, int y) { return 1e-3 * ((x + 2 * y) % 5); }));
  CHECK(surface(wavy).size() == 2 * (columns - 1) * (rows - 1));
  CHECK_FALSE(find(scan([](int, int) { return 0.0; })).has_value());
}

TEST_CASE("what is no raster is not taken for one") {
  Run run;
  for (const Sampling sampling : {Sampling::BlueNoise, Sampling::Random, Sampling::DensityStep}) {
    SampleOptions options;
    options.sampling = sampling;
    options.n = 1000;
    for (const Shape shape : {Shape::FlatDisc, Shape::HemisphereCap}) {
      options.shape = shape;
      CHECK_FALSE(find(sample(options, run).points).has_value());
    }
  }
  SampleOptions tunnel;
  tunnel.sampling = Sampling::Grid;
  tunnel.shape = Shape::HalfTunnel;
  tunnel.n = 1000;
  CHECK_FALSE(find(sample(tunnel, run).points).has_value());
  auto shaken = scan(bowl);
  for (std::size_t i = 0; i < shaken.size(); ++i) {
    shaken[i].x += 0.2 * std::sin(37.0 * static_cast<double>(i));
    shaken[i].y += 0.2 * std::sin(91.0 * static_cast<double>(i));
  }
  CHECK_FALSE(find(turned(shaken)).has_value());
}

TEST_CASE("a grid whose rim is not of it is no raster") {
  for (const Sampling sampling : {Sampling::Grid, Sampling::ScanLines}) {
    SampleOptions options;
    options.shape = Shape::WavySaddle;
    options.sampling = sampling;
    options.n = 10000;
    CHECK_FALSE(find(sample(options, {}).points).has_value());
  }
}

// Every third point, and every third triangle, is of the same part.
TEST_CASE("samples of parts, added up in any order, give the view and the cells of the whole") {
  const auto points = turned(scan(bowl));
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const OwnFrame own = own_frame(points, {});
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  ViewSample sum{own.count, {}};
  for (const Index part : {2, 0, 1}) {
    std::vector<Index> ids;
    std::ranges::copy_if(all, std::back_inserter(ids), [&](Index i) { return i % 3 == part; });
    sum += sample_views(points, ids, neighbours, own, {});
  }
  const auto view = best_view(sum, {}),
             of_whole = best_view(sample_views(points, all, neighbours, own, {}), {});
  REQUIRE(view.has_value());
  REQUIRE(of_whole.has_value());
  CHECK(view->step == of_whole->step);
  CHECK(distance(view->direction, of_whole->direction) == 0);

  const auto [u, v] = axes_across(view->direction);
  std::vector<UV> seen;
  for (const Point p : points) seen.push_back({dot(own.in(p), u), dot(own.in(p), v)});
  const std::vector<Triangle> triangles = delaunay(seen, {});
  CellSample cells;
  for (const Index part : {1, 2, 0}) {
    std::vector<Triangle> some;
    for (std::size_t t = static_cast<std::size_t>(part); t < triangles.size(); t += 3)
      some.push_back(triangles[t]);
    cells += sample_cells(points, some, seen, own, {});
  }
  const auto limit = largest_cell(cells, view->step);
  const auto limit_of_whole = largest_cell(sample_cells(points, triangles, seen, own, {}), view->step);
  REQUIRE(limit.has_value());
  REQUIRE(limit_of_whole.has_value());
  CHECK(limit->area == limit_of_whole->area);
  CHECK(limit->radius == limit_of_whole->radius);
}

TEST_CASE("a depth jump parts the surface, a steep slope does not") {
  for (const double jump : {3.0, 12.0}) {
    const auto points = turned(scan([&](int x, int y) { return bowl(x, y) + (x < 15 ? 0 : jump); }));
    std::size_t over = 0;
    for (const Triangle& t : surface(points)) {
      std::set<bool> sides;
      for (const Index v : t) sides.insert(v % columns < 15);
      over += sides.size() == 2;
    }
    CHECK(over == (jump > 6 ? 0 : 2 * (rows - 1)));
  }
}

TEST_CASE("a missing sample leaves a hole, and rims do not touch in a point") {
  auto points = scan(bowl);
  const auto at = [&](int x, int y) { return points.begin() + y * columns + x; };
  points.erase(at(11, 11));
  points.erase(at(10, 10));  // diagonal to the other: their holes would touch
  points = turned(points);
  const auto triangles = surface(points);
  // Two holes of one sample each would take two cells' worth of four triangles.
  CHECK(triangles.size() < 2 * (columns - 1) * (rows - 1) - 7);
  std::vector<std::set<Index>> rim(points.size());
  const auto count = [&](Index a, Index b) {
    return std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
    });
  };
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      if (count(a, b) != 1) continue;
      rim[a].insert(b);
      rim[b].insert(a);
    }
  }
  for (const auto& ends : rim) CHECK((ends.empty() || ends.size() == 2));
}

}  // namespace
}  // namespace rimline
