// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/anisotropy.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rimline/sample.h"

using namespace rimline;

namespace {

// Offsets in a lattice of steps 1 / root(ratio) along a direction and root(ratio) across it.
std::vector<Offset> lattice(double ratio, double angle) {
  std::vector<Offset> offsets;
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const double x = i / std::sqrt(ratio), y = j * std::sqrt(ratio);
      if ((i == 0 && j == 0) || x * x + y * y > 9) continue;
      offsets.push_back(
          {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y});
    }
  }
  return offsets;
}

double mean_of(Points points, const Neighbours& neighbours, const std::vector<double>& spacing) {
  std::vector<double> at_points;
  for (Index i = 0; i < neighbours.size(); i += 8)
    at_points.push_back(anisotropy_at(points, neighbours, spacing, i));
  return mean_anisotropy(at_points);
}

}  // namespace

TEST_CASE("in a lattice the anisotropy makes both steps alike, whichever way it is turned") {
  for (const double ratio : {1.0, 2.0, 3.0}) {
    for (const double angle : {0.0, 0.4, 1.2}) {
      const Anisotropy w = find_anisotropy(lattice(ratio, angle));
      const double c = std::cos(angle), s = std::sin(angle);
      const double along = w.xx * c * c + 2 * w.xy * c * s + w.yy * s * s;
      const double across = w.xx * s * s - 2 * w.xy * c * s + w.yy * c * c;
      CHECK(std::sqrt(along) == doctest::Approx(std::sqrt(ratio)).epsilon(0.1));
      CHECK(std::sqrt(across) == doctest::Approx(1 / std::sqrt(ratio)).epsilon(0.1));
      CHECK(w.xx * w.yy - w.xy * w.xy == doctest::Approx(1));
    }
  }
}

TEST_CASE("no offsets, or all on one line, anisotropy nothing") {
  CHECK(find_anisotropy({}).xx == 1);
  CHECK(find_anisotropy({{1, 0}, {-1, 0}}).xy == 0);
}

TEST_CASE("scan lines are told from all other samples, under noise as well") {
  for (const Shape shape : {Shape::FlatDisc, Shape::CurledStrip}) {
    for (const Sampling sampling : all_samplings()) {
      for (const double noise : {0.0, 0.5}) {
        CAPTURE(name(shape));
        CAPTURE(name(sampling));
        CAPTURE(noise);
        SampleOptions options;
        options.shape = shape;
        options.sampling = sampling;
        options.n = 2000;
        options.noise = noise;
        const Sample drawn = sample(options, {});
        const Neighbours neighbours = find_neighbours(drawn.points, 40, {});
        const auto spacing = local_spacing(drawn.points, neighbours);
        const double ratio = mean_of(drawn.points, neighbours, spacing);
        CHECK((ratio > 0) == (sampling == Sampling::ScanLines));
      }
    }
  }
}

TEST_CASE("rows two steps apart, as in the strips of a mesh, are no scan lines; rows four steps apart are") {
  const auto ratio_of = [](double apart) {
    std::vector<Point> points;
    for (int row = 0; row < 40; ++row) {
      for (int i = 0; i < 40; ++i) points.push_back({i + 0.5 * (row & 1), apart * row, 0});
    }
    const Neighbours neighbours = find_neighbours(points, 40, {});
    return mean_of(points, neighbours, local_spacing(points, neighbours));
  };
  CHECK(ratio_of(2.2) == 0);
  CHECK(ratio_of(4) > 1);
}
