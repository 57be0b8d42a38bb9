// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/hard_clouds.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/random.h"

namespace rimline::bench {
namespace {

constexpr double circle = 2 * std::numbers::pi;

template <std::size_t N>
double one_of(Random& random, const std::array<double, N>& values) {
  return values[random.below(N)];
}

int between(Random& random, int least, int most) {
  return least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)));
}

// Box and Muller.
double normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(circle * random.uniform());
}

Point normal_point(Random& random) { return {normal(random), normal(random), normal(random)}; }

using Piece = std::vector<Point>;

// Rows and columns, some of them bent, noisy or with points missing.
Piece plate(Random& random) {
  const int rows = between(random, 2, 24), columns = between(random, 2, 24);
  const double noise = one_of<4>(random, {0, 0, 0.1, 0.4}), kept = one_of<4>(random, {1, 1, 0.9, 0.6});
  const double height = one_of<3>(random, {0, 1, 4}), wave = one_of<2>(random, {1.5, 4});
  Piece piece;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (random.uniform() >= kept) continue;
      piece.push_back(Point{double(x), double(y), height * std::sin(x / wave)} +
                      noise * normal_point(random));
    }
  }
  return piece;
}

Piece line(Random& random) {
  const double step = one_of<3>(random, {0.25, 1, 2.5});
  Piece piece;
  for (int i = between(random, 3, 120); i > 0; --i) piece.push_back({step * i, 0, 0});
  return piece;
}

// A sphere of random points, whole or cut.
Piece sphere(Random& random) {
  const int count = between(random, 20, 500);
  const double radius = std::sqrt(count) / 3, cut = one_of<4>(random, {2, 0.8, 0.3, -0.2});
  Piece piece;
  for (int i = 0; i < count; ++i) {
    const Point p = normal_point(random);
    const double length = norm(p);
    if (length > 0 && p.z < cut * length) piece.push_back((radius / length) * p);
  }
  return piece;
}

Piece lump(Random& random) {
  const double size = one_of<3>(random, {0.1, 1, 6});
  Piece piece;
  for (int i = between(random, 1, 200); i > 0; --i) piece.push_back(size * normal_point(random));
  return piece;
}

Piece ring(Random& random) {
  const int count = between(random, 3, 200);
  Piece piece;
  for (int i = 0; i < count; ++i) {
    const double a = circle * i / count;
    piece.push_back((count / circle) * Point{std::cos(a), std::sin(a), 0});
  }
  return piece;
}

Piece tube(Random& random) {
  const int around = between(random, 6, 40), rings = between(random, 1, 30);
  Piece piece;
  for (int z = 0; z < rings; ++z) {
    for (int i = 0; i < around; ++i) {
      const double a = circle * i / around, r = around / circle;
      piece.push_back({r * std::cos(a), r * std::sin(a), double(z)});
    }
  }
  return piece;
}

Piece patch(Random& random) {
  const int count = between(random, 5, 800);
  const double side = std::sqrt(count) * one_of<2>(random, {0.5, 1});
  Piece piece;
  for (int i = 0; i < count; ++i) piece.push_back({side * random.uniform(), side * random.uniform(), 0});
  return piece;
}

struct Maker {
  Piece (*make)(Random&);
  bool is_surface;
};

constexpr std::array<Maker, 8> makers{{{plate, true},
                                       {plate, true},
                                       {line, false},
                                       {sphere, true},
                                       {lump, false},
                                       {ring, false},
                                       {tube, true},
                                       {patch, true}}};

// A turn about a random axis (Rodrigues).
Piece turned(Piece piece, Random& random) {
  Point axis = normal_point(random);
  axis = (1 / std::max(norm(axis), 1e-9)) * axis;
  const double angle = circle * random.uniform(), c = std::cos(angle), s = std::sin(angle);
  for (Point& p : piece) p = c * p + s * cross(axis, p) + ((1 - c) * dot(axis, p)) * axis;
  return piece;
}

void round_to(double step, Piece& points) {
  for (Point& p : points)
    p = {step * std::round(p.x / step), step * std::round(p.y / step), step * std::round(p.z / step)};
}

void spoil(Piece& points, Random& random) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  switch (random.below(20)) {
    case 0:
    case 1:
    case 2: return round_to(0.5, points);
    case 3:
    case 4: return round_to(1, points);
    case 5:
    case 6: {
      const std::size_t count = points.size();
      for (std::size_t i = 0; i < count / 2; ++i) points.push_back(points[random.below(count)]);
      return;
    }
    case 7:
      for (Point& p : points) {
        if (random.uniform() < 0.05) p = {nan, nan, nan};
      }
      return;
    case 8:
      for (Point& p : points) p = p + Point{1e6, 1e6, 1e6};
      return;
    case 9:
      for (Point& p : points) p.z = 0;
      return;
    default: return;
  }
}

}  // namespace

HardCloud hard_cloud(std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  HardCloud cloud;
  constexpr std::size_t least_surface = 30;
  for (int pieces = static_cast<int>(one_of<7>(random, {1, 1, 2, 3, 5, 8, 15})); pieces > 0; --pieces) {
    const Maker& maker = makers[random.below(makers.size())];
    Piece piece = maker.make(random);
    cloud.has_surface = cloud.has_surface || (maker.is_surface && piece.size() >= least_surface);
    if (random.uniform() < 0.7) piece = turned(std::move(piece), random);
    const double scale = one_of<6>(random, {1, 1, 1, 0.1, 10, 0.01});
    const Point at = one_of<5>(random, {0, 1, 5, 20, 100}) * normal_point(random);
    for (const Point& p : piece) cloud.points.push_back(scale * p + at);
  }
  spoil(cloud.points, random);
  return cloud;
}

}  // namespace rimline::bench
