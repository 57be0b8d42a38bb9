// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/sample.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <string>

#include "rimline/neighbours.h"

namespace rimline {
namespace {

using std::numbers::pi;

Sample draw(Shape shape, Sampling sampling, std::size_t n, std::uint64_t seed = 1, double noise = 0) {
  Run run;
  run.seed = seed;
  return sample({shape, sampling, n, noise}, run);
}

// Calls body for every shape and sampling that go together, one point set each.
template <class Body>
void for_all(std::size_t n, const Body& body) {
  for (const Shape shape : all_shapes()) {
    for (const Sampling sampling : all_samplings()) {
      if (shape == Shape::ClosedSphere && sampling == Sampling::Cropped) continue;
      CAPTURE(std::string(name(shape)));
      CAPTURE(std::string(name(sampling)));
      body(shape, sampling, draw(shape, sampling, n));
    }
  }
}

// How far a point is from satisfying the equation of the surface, written down apart from the library's
// charts.
double off_surface(Shape shape, const Point& p) {
  const double rho = std::hypot(p.x, p.y);
  switch (shape) {
    case Shape::FlatDisc: return std::abs(p.z) + std::max(0.0, rho - 1);
    case Shape::SquareWithHoles: return std::abs(p.z);
    case Shape::BumpySquare:
      return std::abs(p.z - 0.08 * std::sin(9.42 * p.x + 0.5) * std::sin(9.42 * p.y + 1.1));
    case Shape::WavySaddle:
      return std::abs(p.z - 0.3 * (p.x * p.x - p.y * p.y) - 0.03 * std::sin(5 * p.x) * std::cos(5 * p.y));
    case Shape::HemisphereCap: return std::abs(norm(p) - 1) + std::max(0.0, -p.z);
    case Shape::SphereMinusCap:
    case Shape::ClosedSphere: return std::abs(norm(p) - 1);
    case Shape::HalfTunnel: return std::abs(std::hypot(p.x, p.z) - 0.35) + std::max(0.0, -p.z);
    case Shape::CurledStrip: {
      const double r = std::hypot(p.x, p.z);
      return r * std::abs(std::remainder(std::log(r / 0.3) / 0.15 - std::atan2(p.z, p.x), 2 * pi));
    }
    case Shape::Pipe: return std::abs(rho - 0.3);
    case Shape::CappedTube: return std::abs((p.z <= 0.9 ? rho : std::hypot(rho, p.z - 0.9)) - 0.3);
    case Shape::TorusMinusCap: return std::abs(std::hypot(rho - 0.65, p.z) - 0.35);
    case Shape::MoebiusStrip: {
      double angle = std::atan2(p.y, p.x);
      return std::abs((rho - 1) * std::sin(angle / 2) - p.z * std::cos(angle / 2));
    }
  }
  return 1;
}

// How far a boundary point is from the boundary curves.
double off_rim(Shape shape, const Point& p) {
  const double rho = std::hypot(p.x, p.y);
  const auto of_box = [](double u, double v, double width, double height) {
    return std::min({std::abs(u), std::abs(v), std::abs(u - width), std::abs(v - height)});
  };
  switch (shape) {
    case Shape::FlatDisc: return std::abs(rho - 1);
    case Shape::BumpySquare: return of_box(p.x, p.y, 1, 1);
    case Shape::SquareWithHoles:
      return std::min({of_box(p.x, p.y, 1, 1), std::abs(std::hypot(p.x - 0.27, p.y - 0.27) - 0.13),
                       std::abs(std::hypot(p.x - 0.69, p.y - 0.40) - 0.16),
                       std::abs(std::hypot(p.x - 0.38, p.y - 0.75) - 0.12)});
    case Shape::WavySaddle: return std::abs(rho - 1 - 0.12 * std::cos(5 * std::atan2(p.y, p.x)));
    case Shape::HemisphereCap:
    case Shape::CappedTube: return std::abs(p.z);
    case Shape::SphereMinusCap: return std::abs(p.z + std::sin(70 * pi / 180));
    case Shape::HalfTunnel: return of_box(p.z, p.y, 9, 1.2);
    case Shape::CurledStrip: {
      const double r = std::hypot(p.x, p.z);
      return of_box(r - 0.3, p.y, 0.3 * std::exp(0.15 * 3 * pi) - 0.3, 0.8);
    }
    case Shape::Pipe: return std::min(std::abs(p.z), std::abs(p.z - 1.2));
    case Shape::TorusMinusCap: {
      const double tube = std::atan2(p.z, rho - 0.65);
      return std::abs(std::hypot(std::atan2(p.y, p.x), 0.35 * tube) - 0.4);
    }
    case Shape::MoebiusStrip: return std::abs(std::hypot(rho - 1, p.z) - 0.35);
    case Shape::ClosedSphere: return 1;
  }
  return 1;
}

std::size_t loops_of(Shape shape) {
  if (shape == Shape::ClosedSphere) return 0;
  if (shape == Shape::Pipe) return 2;
  return shape == Shape::SquareWithHoles ? 4 : 1;
}

// Counter-clockwise is positive.
double signed_area(const Sample& s, const Loop& loop, double Point::*first, double Point::*second) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Point &a = s.points[loop.points[i]], &b = s.points[loop.points[(i + 1) % loop.points.size()]];
    sum += a.*first * b.*second - b.*first * a.*second;
  }
  return sum / 2;
}

double signed_area(const Sample& s, const Loop& loop) { return signed_area(s, loop, &Point::x, &Point::y); }

bool edges_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) > 0;
  };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

double median(std::span<const double> given) {
  std::vector<double> values(given.begin(), given.end());
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

std::vector<double> nearest_distances(Points points) {
  const Neighbours neighbours = find_neighbours(points, 1, {});
  std::vector<double> nearest;
  for (Index i = 0; i < neighbours.size(); ++i) nearest.push_back(distance_to(points, neighbours, i, 0));
  return nearest;
}

TEST_CASE("every point lies on the surface and every loop point on its rim") {
  for_all(1000, [](Shape shape, Sampling sampling, const Sample& s) {
    double worst = 0, worst_rim = 0;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      worst = std::max(worst, off_surface(shape, s.points[i]));
      if (s.boundary[i] != 0) worst_rim = std::max(worst_rim, off_rim(shape, s.points[i]));
    }
    CHECK(worst < 1e-12);
    if (sampling != Sampling::Cropped) CHECK(worst_rim < 1e-12);
  });
}

TEST_CASE("the loops are as many as the shape has, and hold each flagged point once and no other") {
  for_all(1000, [](Shape shape, Sampling, const Sample& s) {
    REQUIRE(s.loops.size() == loops_of(shape));
    std::set<Index> on_loops;
    std::size_t count = 0;
    for (const Loop& loop : s.loops) {
      on_loops.insert(loop.points.begin(), loop.points.end());
      count += loop.points.size();
      CHECK((loop.kind == LoopKind::Outer) == (&loop == s.loops.data()));
    }
    CHECK(on_loops.size() == count);
    CHECK(std::count(s.boundary.begin(), s.boundary.end(), 1) == count);
    CHECK(std::all_of(on_loops.begin(), on_loops.end(), [&](Index i) { return s.boundary[i] == 1; }));
  });
}

TEST_CASE(
    "consecutive points of a loop are no farther apart than 2.5 spacings, and the length is their sum") {
  for_all(1000, [](Shape, Sampling, const Sample& s) {
    const auto spacing = local_spacing(s.points, find_neighbours(s.points, 6, {}));
    for (const Loop& loop : s.loops) {
      double length = 0;
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Index a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
        const double step = distance(s.points[a], s.points[b]);
        CHECK(step < 2.5 * std::max(spacing[a], spacing[b]));
        length += step;
      }
      CHECK(loop.length == doctest::Approx(length));
    }
  });
}

TEST_CASE("the count is within 10 % of what was asked for") {
  for (const std::size_t n : {200, 1000, 4000}) {
    for_all(n, [&](Shape, Sampling sampling, const Sample& s) {
      CHECK(std::abs(static_cast<double>(s.points.size()) - n) <= 0.1 * n);
      if (sampling == Sampling::Random) CHECK(s.points.size() == n);
    });
  }
}

TEST_CASE("no two points coincide") {
  for_all(1000, [](Shape, Sampling sampling, const Sample& s) {
    const auto nearest = nearest_distances(s.points);
    const double least = *std::min_element(nearest.begin(), nearest.end());
    CHECK(least > 0);
    if (sampling != Sampling::Random) CHECK(least > 0.2 * median(nearest));
  });
}

TEST_CASE("loops have the surface on the left: outer ones turn left seen from above, holes right") {
  for (const Sampling sampling : all_samplings()) {
    CAPTURE(std::string(name(sampling)));
    for (const Shape shape : {Shape::FlatDisc, Shape::BumpySquare, Shape::WavySaddle, Shape::SquareWithHoles,
                              Shape::HemisphereCap, Shape::SphereMinusCap, Shape::HalfTunnel,
                              Shape::CappedTube, Shape::Pipe}) {  // of the pipe the upper rim is the hole
      CAPTURE(std::string(name(shape)));
      const Sample s = draw(shape, sampling, 1000);
      for (const Loop& loop : s.loops) CHECK((signed_area(s, loop) > 0) == (loop.kind == LoopKind::Outer));
    }
    // The cap of the torus is looked at from outside, along -x.
    const Sample torus = draw(Shape::TorusMinusCap, sampling, 1000);
    CHECK(signed_area(torus, torus.loops[0], &Point::y, &Point::z) < 0);
    Sample strip = draw(Shape::CurledStrip, sampling, 1000);
    for (Point& p : strip.points) p.x = std::hypot(p.x, p.z);  // unrolled but for the scale
    CHECK(signed_area(strip, strip.loops[0]) > 0);
  }
}

TEST_CASE("the loops of flat shapes do not cross themselves or each other") {
  for (const Shape shape : {Shape::FlatDisc, Shape::SquareWithHoles}) {
    for (const Sampling sampling : all_samplings()) {
      CAPTURE(std::string(name(shape)));
      CAPTURE(std::string(name(sampling)));
      const Sample s = draw(shape, sampling, 1000);
      std::vector<std::pair<Index, Index>> edges;
      for (const Loop& loop : s.loops) {
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
          edges.emplace_back(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
        }
      }
      int crossings = 0;
      for (const auto& [a, b] : edges) {
        for (const auto& [c, d] : edges) {
          if (a == c || a == d || b == c || b == d) continue;
          crossings += edges_cross(s.points[a], s.points[b], s.points[c], s.points[d]) ? 1 : 0;
        }
      }
      CHECK(crossings == 0);
    }
  }
}

TEST_CASE("the loop of a flat disc is as long as a circle and encloses its area") {
  const Sample s = draw(Shape::FlatDisc, Sampling::BlueNoise, 4000);
  CHECK(s.loops[0].length == doctest::Approx(2 * pi).epsilon(0.001));
  CHECK(signed_area(s, s.loops[0]) == doctest::Approx(pi).epsilon(0.001));
}

// The spacing h that a count tells: n = area / h^2 + rim / (2 h).
double spacing_from_count(double n, double area, double rim) {
  return (rim / 2 + std::sqrt(rim * rim / 4 + 4 * area * n)) / (2 * n);
}

TEST_CASE("blue noise keeps its distance and leaves no gap") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Sample s = draw(Shape::FlatDisc, Sampling::BlueNoise, 4000, seed);
    const double radius = 0.8346 * spacing_from_count(static_cast<double>(s.points.size()), pi, 2 * pi);
    const auto nearest = nearest_distances(s.points);
    CHECK(*std::min_element(nearest.begin(), nearest.end()) > 0.97 * radius);
    // Farthest that a place in the disc is from all points.
    double farthest = 0;
    for (int i = 0; i < 60; ++i) {
      for (int j = 0; j < 60; ++j) {
        const Point place{-1 + (2 * i + 1) / 60.0, -1 + (2 * j + 1) / 60.0, 0};
        if (norm(place) > 1) continue;
        double closest = 2;
        for (const Point& p : s.points) closest = std::min(closest, distance(p, place));
        farthest = std::max(farthest, closest);
      }
    }
    CHECK(farthest < 1.04 * radius);
  }
}

TEST_CASE("only random samples have interior points within half a spacing of the boundary curve") {
  for_all(1000, [](Shape, Sampling sampling, const Sample& s) {
    if (sampling != Sampling::Random) CHECK(s.near_boundary == s.boundary);
  });
  const Sample s = draw(Shape::FlatDisc, Sampling::Random, 20000);
  const double half = 0.5 * std::sqrt(pi / static_cast<double>(s.points.size()));
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const double depth = 1 - norm(s.points[i]);
    if (depth < 0.98 * half) CHECK(s.near_boundary[i] == 1);
    if (depth > 1.02 * half) CHECK(s.near_boundary[i] == 0);
  }
}

TEST_CASE("random points are spread by area") {
  // By Archimedes the height of a uniform point on the sphere is uniform.
  const Sample s = draw(Shape::ClosedSphere, Sampling::Random, 40000);
  int bins[10] = {};
  for (const Point& p : s.points) ++bins[std::clamp(static_cast<int>((p.z + 1) * 5), 0, 9)];
  for (const int bin : bins) CHECK(std::abs(bin - 4000) < 300);  // five standard deviations
}

TEST_CASE("a density step is ten to one") {
  const Sample s = draw(Shape::FlatDisc, Sampling::DensityStep, 20000);
  double left = 0, right = 0;
  for (const Point& p : s.points) {
    if (norm(p) > 0.9 || std::abs(p.x) < 0.1) continue;
    (p.x < 0 ? left : right) += 1;
  }
  CHECK(left / right == doctest::Approx(10).epsilon(0.05));
}

TEST_CASE("a smooth change of density is exponential and ten to one from end to end") {
  const Sample s = draw(Shape::HalfTunnel, Sampling::SmoothDensity, 20000);
  double bins[10] = {};
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    if (s.boundary[i] == 0) ++bins[std::clamp(static_cast<int>(s.points[i].y / 0.12), 0, 9)];
  }
  for (int i = 2; i < 9; ++i)
    CHECK(bins[i] / bins[i - 1] == doctest::Approx(std::pow(10, -0.1)).epsilon(0.1));
  CHECK(bins[1] / bins[8] == doctest::Approx(std::pow(10, 0.7)).epsilon(0.1));
}

TEST_CASE("on scan lines points are four times as close along the lines as the lines are") {
  const Sample s = draw(Shape::FlatDisc, Sampling::ScanLines, 5000);
  std::set<double> lines;
  std::vector<Point> interior;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    if (s.boundary[i] == 0) interior.push_back(s.points[i]);
  }
  for (const Point& p : interior) lines.insert(p.y);
  std::vector<double> gaps;
  for (auto line = lines.begin(); std::next(line) != lines.end(); ++line)
    gaps.push_back(*std::next(line) - *line);
  CHECK(median(gaps) / median(nearest_distances(interior)) == doctest::Approx(4).epsilon(0.03));
}

TEST_CASE("the nearest four neighbours on a grid are one step away along the axes") {
  const Sample s = draw(Shape::SquareWithHoles, Sampling::Grid, 2000);
  const Neighbours neighbours = find_neighbours(s.points, 4, {});
  const double step = median(nearest_distances(s.points));
  int regular = 0, interior = 0;
  for (Index i = 0; i < neighbours.size(); ++i) {
    if (s.boundary[i] != 0) continue;
    const auto nearest = neighbours.of(i);
    ++interior;
    regular += std::all_of(nearest.begin(), nearest.end(), [&](Index j) {
      return std::abs(distance(s.points[i], s.points[j]) - step) < 1e-9;
    });
  }
  CHECK(regular > 0.8 * interior);  // all but those at the round holes
}

TEST_CASE("noise has the deviation asked for, no drift, and leaves the truth alone") {
  for (const double noise : {0.1, 0.5}) {
    const Sample clean = draw(Shape::BumpySquare, Sampling::BlueNoise, 8000, 5);
    const Sample noisy = draw(Shape::BumpySquare, Sampling::BlueNoise, 8000, 5, noise);
    REQUIRE(noisy.points.size() == clean.points.size());
    CHECK(noisy.boundary == clean.boundary);
    CHECK(noisy.loops[0].points == clean.loops[0].points);
    CHECK(noisy.loops[0].length == clean.loops[0].length);
    const auto nearest = nearest_distances(clean.points);
    const double count = static_cast<double>(nearest.size());
    double sum_nearest = 0;
    Point sum, squares;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const Point d = noisy.points[i] - clean.points[i];
      sum_nearest += nearest[i];
      sum = sum + d;
      squares = squares + Point{d.x * d.x, d.y * d.y, d.z * d.z};
    }
    const double sigma = noise * sum_nearest / count;
    for (const double square : {squares.x, squares.y, squares.z}) {
      CHECK(std::sqrt(square / count) == doctest::Approx(sigma).epsilon(0.05));
    }
    CHECK(norm(sum) / count < 5 * sigma / std::sqrt(count));
  }
}

TEST_CASE("noise follows the local spacing") {
  const Sample clean = draw(Shape::FlatDisc, Sampling::DensityStep, 10000, 5);
  const Sample noisy = draw(Shape::FlatDisc, Sampling::DensityStep, 10000, 5, 0.2);
  std::vector<double> left, right;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    (clean.points[i].x < 0 ? left : right).push_back(distance(clean.points[i], noisy.points[i]));
  }
  CHECK(median(right) / median(left) == doctest::Approx(std::sqrt(10)).epsilon(0.1));
}

TEST_CASE("the same seed gives the same bytes on one and two threads; another seed other points") {
  for (const Sampling sampling : all_samplings()) {
    CAPTURE(std::string(name(sampling)));
    const SampleOptions options{Shape::WavySaddle, sampling, 3000, 0.2};
    Run one, two, other;
    one.threads = 1;
    two.threads = 2;
    other.seed = 2;
    const Sample a = sample(options, one), b = sample(options, two), c = sample(options, other);
    CHECK(a.points == b.points);
    CHECK(a.boundary == b.boundary);
    CHECK(a.near_boundary == b.near_boundary);
    REQUIRE(a.loops.size() == b.loops.size());
    for (std::size_t i = 0; i < a.loops.size(); ++i) CHECK(a.loops[i].points == b.loops[i].points);
    CHECK(a.points != c.points);
  }
}

TEST_CASE("the order of the points tells nothing about the boundary") {
  const Sample s = draw(Shape::FlatDisc, Sampling::BlueNoise, 4000);
  const auto half = s.boundary.begin() + s.boundary.size() / 2;
  const double first = std::count(s.boundary.begin(), half, 1),
               all = std::count(s.boundary.begin(), s.boundary.end(), 1);
  CHECK(std::abs(first - all / 2) < 5 * std::sqrt(all / 4));
}

TEST_CASE(
    "the layers of the curled strip are more than two spacings apart at every sampling of 1000 points") {
  for (const Sampling sampling : all_samplings()) {
    CAPTURE(std::string(name(sampling)));
    const Sample s = draw(Shape::CurledStrip, sampling, 1000);
    const auto spacing = local_spacing(s.points, find_neighbours(s.points, 6, {}));
    // Place along the spiral: the angle, unwound.
    const auto angle = [](const Point& p) { return std::log(std::hypot(p.x, p.z) / 0.3) / 0.15; };
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (std::abs(angle(s.points[i]) - angle(s.points[j])) < pi) continue;
        closest = std::min(closest, distance(s.points[i], s.points[j]) / std::max(spacing[i], spacing[j]));
      }
    }
    CHECK(closest > 2);
  }
}

TEST_CASE("names are distinct and as the tool spells them") {
  std::set<std::string> names;
  for (const Shape shape : all_shapes()) names.insert(name(shape));
  for (const Sampling sampling : all_samplings()) names.insert(name(sampling));
  CHECK(names.size() == 20);
  CHECK(names.count("square-with-holes") == 1);
  CHECK(names.count("scan-lines") == 1);
}

void check_refused(const SampleOptions& options) {
  try {
    sample(options, {});
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::BadOption);
    CHECK(std::string(error.what()).find(name(options.shape)) == 0);
  }
}

TEST_CASE("what can not be sampled is refused in words") {
  check_refused({Shape::ClosedSphere, Sampling::Cropped, 1000, 0});
  check_refused({Shape::FlatDisc, Sampling::BlueNoise, 0, 0});
  check_refused({Shape::FlatDisc, Sampling::Random, std::numeric_limits<std::size_t>::max(), 0});
  check_refused({Shape::FlatDisc, Sampling::BlueNoise, 1000, -1});
  check_refused({Shape::FlatDisc, Sampling::BlueNoise, 1000, std::numeric_limits<double>::quiet_NaN()});
  check_refused({Shape::SphereMinusCap, Sampling::BlueNoise, 50, 0});  // four points on its rim
}

TEST_CASE("a stopped run samples nothing") {
  const std::atomic<bool> stop{true};
  Run run;
  run.stop = &stop;
  for (const Sampling sampling : all_samplings()) {
    try {
      sample({Shape::FlatDisc, sampling, 1000, 0}, run);
      FAIL("not stopped");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::Cancelled);
    }
  }
}

}  // namespace
}  // namespace rimline
