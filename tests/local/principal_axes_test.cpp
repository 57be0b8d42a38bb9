// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/principal_axes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "shapes.h"

namespace rimline {
namespace {

Point times(const Covariance& m, Point p) {
  return {m.xx * p.x + m.xy * p.y + m.xz * p.z, m.xy * p.x + m.yy * p.y + m.yz * p.z,
          m.xz * p.x + m.yz * p.y + m.zz * p.z};
}

// The matrix with these eigenvalues on axes turned by the three angles.
Covariance with_eigenvalues(double a, double b, double c, double turn) {
  const auto v = shapes::turned({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, turn, 2 * turn, 3 * turn);
  const auto sum = [&](double Point::*i, double Point::*j) {
    return a * v[0].*i * v[0].*j + b * v[1].*i * v[1].*j + c * v[2].*i * v[2].*j;
  };
  return {sum(&Point::x, &Point::x), sum(&Point::x, &Point::y), sum(&Point::x, &Point::z),
          sum(&Point::y, &Point::y), sum(&Point::y, &Point::z), sum(&Point::z, &Point::z)};
}

// The definition: m v = lambda v, orthonormal, ascending; errors relative to the largest eigenvalue.
double error(const Covariance& m) {
  const PrincipalAxes axes = principal_axes(m);
  const double size = std::max(std::abs(axes.lambda[0]), std::abs(axes.lambda[2]));
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const Point residual = times(m, axes.v[i]) - axes.lambda[i] * axes.v[i];
    worst = std::max(worst, size > 0 ? norm(residual) / size : norm(residual));
    for (int j = 0; j < 3; ++j) {
      worst = std::max(worst, std::abs(dot(axes.v[i], axes.v[j]) - (i == j)));
    }
    if (i > 0) CHECK(axes.lambda[i - 1] <= axes.lambda[i]);
  }
  return worst;
}

TEST_CASE("eigenvalues and vectors solve the equation that defines them, for random matrices") {
  Random random(2);
  const auto number = [&] { return 2 * random.uniform() - 1; };
  for (int i = 0; i < 20'000; ++i) {
    CHECK(error({number(), number(), number(), number(), number(), number()}) < 1e-14);
  }
}

TEST_CASE("close, equal, zero and far apart eigenvalues have vectors as exact as any") {
  const double values[] = {0, 1e-300, 1e-30, 1e-16, 1e-9, 0.5, 1 - 1e-15, 1, 1 + 1e-15, 1 + 1e-8, 1e9};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        for (const double turn : {0.0, 1e-9, 0.1, 0.7, 2.0}) {
          CHECK(error(with_eigenvalues(a, b, c, turn)) < 1e-14);
        }
      }
    }
  }
}

TEST_CASE(
    "lanes hold the same bytes as one matrix after another, those without and with equal eigenvalues too") {
  Random random(3);
  const auto number = [&] { return 2 * random.uniform() - 1; };
  std::vector<Covariance> matrices{{}, {2, 0, 0, 2, 0, 2}, {1, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 3}};
  for (const double a : {0.0, 1e-9, 1.0}) {
    for (const double turn : {0.0, 0.7}) matrices.push_back(with_eigenvalues(a, 1, 1 + a, turn));
  }
  while (matrices.size() < 400) {
    matrices.push_back({number(), number(), number(), number(), number(), number()});
  }
  for (std::size_t first = 0; first < matrices.size(); first += lanes) {
    CovarianceLanes m;
    for (int l = 0; l < lanes; ++l) {
      const Covariance& one = matrices[first + l];
      m.xx[l] = one.xx, m.xy[l] = one.xy, m.xz[l] = one.xz;
      m.yy[l] = one.yy, m.yz[l] = one.yz, m.zz[l] = one.zz;
    }
    PrincipalAxesLanes found;
    principal_axes(m, found);
    for (int l = 0; l < lanes; ++l) {
      const PrincipalAxes alone = principal_axes(matrices[first + l]), in_lane = found.of(l);
      for (int i = 0; i < 3; ++i) {
        CHECK(in_lane.lambda[i] == alone.lambda[i]);
        CHECK(in_lane.v[i] == alone.v[i]);
      }
    }
  }
}

TEST_CASE("known eigenvalues come back") {
  const PrincipalAxes axes = principal_axes(with_eigenvalues(5, 0.25, 3, 0.4));
  CHECK(axes.lambda[0] == doctest::Approx(0.25));
  CHECK(axes.lambda[1] == doctest::Approx(3));
  CHECK(axes.lambda[2] == doctest::Approx(5));
}

}  // namespace
}  // namespace rimline
