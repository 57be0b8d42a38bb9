// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/noise.h"

#include <doctest/doctest.h>

#include <cmath>

#include "local/irregularity.h"
#include "rimline/sample.h"

using namespace rimline;

namespace {

Sample make(Shape shape, Sampling sampling, double noise) {
  SampleOptions options;
  options.shape = shape;
  options.sampling = sampling;
  options.n = 2000;
  options.noise = noise;
  return sample(options, {});
}

std::vector<Distances> distances_of(Points points, const Neighbours& neighbours) {
  const std::vector<double> spacing = local_spacing(points, neighbours);
  std::vector<Distances> distances;
  for (Index i = 0; i < neighbours.size(); ++i)
    distances.push_back(measure_distances(points, neighbours, spacing, i));
  return distances;
}

double level_of(Points points) {
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const std::vector<double> spacing = local_spacing(points, neighbours);
  std::vector<double> deviations;
  for (Index i = 0; i < neighbours.size(); ++i)
    deviations.push_back(quadric_deviation(points, neighbours, spacing, i));
  return noise_level(deviations, variation_of_nearest(distances_of(points, neighbours)));
}

double mean_square_z(Points points) {
  double sum = 0;
  for (const Point& p : points) sum += p.z * p.z / static_cast<double>(points.size());
  return sum;
}

}  // namespace

TEST_CASE("the noise level of a flat disc is its deviation in z over the spacing") {
  for (const double noise : {0.1, 0.2, 0.5}) {
    const Sample disc = make(Shape::FlatDisc, Sampling::BlueNoise, noise);
    double spacing = 0;
    for (const double h : local_spacing(disc.points, find_neighbours(disc.points, 6, {})))
      spacing += h / static_cast<double>(disc.points.size());
    const double truth = std::sqrt(mean_square_z(disc.points)) / spacing;
    CHECK(level_of(disc.points) == doctest::Approx(truth).epsilon(0.15));
  }
}

TEST_CASE("points without noise are not touched, whatever the shape and the sampling") {
  for (const Shape shape : {Shape::FlatDisc, Shape::HemisphereCap, Shape::CurledStrip, Shape::CappedTube}) {
    for (const Sampling sampling : {Sampling::Random, Sampling::ScanLines, Sampling::DensityStep}) {
      CHECK(noise_weight(level_of(make(shape, sampling, 0).points)) == 0);
    }
  }
}

TEST_CASE("relief of coarse points is no noise, and noise on it is told") {
  // Waves of eight spacings that grow with the square of x: no quadric follows them where they are high.
  const Sample disc = make(Shape::FlatDisc, Sampling::BlueNoise, 0);
  const double length = 8 * distance_to(disc.points, find_neighbours(disc.points, 1, {}), 0, 0);
  const auto waves = [&](Points points) {
    std::vector<Point> result(points.begin(), points.end());
    for (Point& p : result) p.z += length / 4 * p.x * p.x * std::sin(6.28 * p.y / length);
    return result;
  };
  CHECK(noise_weight(level_of(waves(disc.points))) == 0);
  CHECK(noise_weight(level_of(waves(make(Shape::FlatDisc, Sampling::BlueNoise, 0.5).points))) == 1);
}

TEST_CASE("noise of a fifth of the spacing is heeded in full") {
  CHECK(noise_weight(level_of(make(Shape::HemisphereCap, Sampling::BlueNoise, 0.2).points)) == 1);
}

TEST_CASE("random points are told from those that keep apart, under noise as well") {
  const auto irregularity_of = [](Shape shape, Sampling sampling, double noise) {
    const Sample drawn = make(shape, sampling, noise);
    const Neighbours neighbours = find_neighbours(drawn.points, 40, {});
    return irregularity(distances_of(drawn.points, neighbours), neighbours.k);
  };
  for (const Shape shape : {Shape::FlatDisc, Shape::CurledStrip}) {
    CHECK(irregularity_of(shape, Sampling::Random, 0) == 1);
    CHECK(irregularity_of(shape, Sampling::Random, 0.5) == doctest::Approx(1));
    for (const Sampling even :
         {Sampling::BlueNoise, Sampling::Grid, Sampling::DensityStep, Sampling::Cropped}) {
      for (const double noise : {0.0, 0.5}) CHECK(irregularity_of(shape, even, noise) == 0);
    }
    for (const double noise : {0.0, 0.5}) CHECK(irregularity_of(shape, Sampling::ScanLines, noise) == 0);
  }
}

TEST_CASE("without its noise a noisy disc is flatter, and nothing moves along it") {
  const Sample disc = make(Shape::FlatDisc, Sampling::BlueNoise, 0.5);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const std::vector<Point> smooth = take_off_noise(disc.points, neighbours, 1, {});
  CHECK(mean_square_z(smooth) < 0.4 * mean_square_z(disc.points));
  CHECK(take_off_noise(disc.points, neighbours, 0, {}) == disc.points);
}

TEST_CASE("points whose squared distances are zero stay where they are, beside others that move") {
  Sample disc = make(Shape::FlatDisc, Sampling::Random, 0.5);
  const std::size_t count = disc.points.size();
  for (std::size_t i = 0; i < count; ++i) disc.points.push_back(1e-300 * disc.points[i]);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  const auto moved = take_off_noise(disc.points, neighbours, 1, {});
  CHECK(moved[0] != disc.points[0]);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    CHECK(is_finite(moved[i]));
    if (i >= count) CHECK(moved[i] == disc.points[i]);
  }
}

TEST_CASE("a set of a few points has a noise level") {
  const std::vector<Point> few{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  CHECK(level_of(few) == 0);
}
