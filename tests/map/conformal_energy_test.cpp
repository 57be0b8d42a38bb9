// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/conformal_energy.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace rimline {
namespace {

const std::array<Point, 3> corners{Point{1, 2, 3}, {2, 2.5, 3.5}, {1.2, 3, 2}};

// The corners in their plane, stretched along two axes there, turned and moved.
ConformalTriangle::Corners mapped(double along, double across, double turn) {
  const Point e = corners[1] - corners[0], f = corners[2] - corners[0];
  const double base = norm(e), x = dot(e, f) / base, y = norm(cross(e, f)) / base;
  const std::array<UV, 3> flat{UV{0, 0}, {base, 0}, {x, y}};
  ConformalTriangle::Corners uv;
  for (int i = 0; i < 3; ++i) {
    const double u = along * flat[i].u, v = across * flat[i].v;
    uv[i] = {7 + std::cos(turn) * u - std::sin(turn) * v, -3 + std::sin(turn) * u + std::cos(turn) * v};
  }
  return uv;
}

}  // namespace

TEST_CASE("a triangle that is turned, moved and grown has energy 1, one stretched the mean of both ratios") {
  const ConformalTriangle triangle(corners);
  CHECK(triangle.area() ==
        doctest::Approx(norm(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2));
  CHECK(triangle.value(mapped(5, 5, 0.7)) == doctest::Approx(1));
  CHECK(triangle.value(mapped(3, 1, 0.7)) == doctest::Approx((3 + 1.0 / 3) / 2));
  CHECK(triangle.value(mapped(1, 4, 2)) == doctest::Approx((4 + 1.0 / 4) / 2));
}

TEST_CASE(
    "an isometry has one and its weight; twice as large both ways, of s^2 and 1 / s^2 the mean on top") {
  const ConformalTriangle triangle(corners, 0.5);
  CHECK(triangle.value(mapped(1, 1, 0.7)) == doctest::Approx(1.5));
  CHECK(triangle.value(mapped(2, 2, 0.7)) == doctest::Approx(1 + 0.5 * (4 + 0.25) / 2));
  CHECK(triangle.value(mapped(3, 1, 2)) ==
        doctest::Approx((3 + 1.0 / 3) / 2 + 0.5 * (9 + 1 + 1.0 / 9 + 1) / 4));
}

TEST_CASE("a triangle that is turned over or flat has infinite energy") {
  const ConformalTriangle triangle(corners);
  CHECK(std::isinf(triangle.value(mapped(1, -1, 0))));
  CHECK(std::isinf(triangle.value({UV{1, 1}, {1, 1}, {1, 1}})));
}

TEST_CASE("the gradient is the slope of the energy, and the Hessian curves up and no less than the energy") {
  double isometry = 0;
  SUBCASE("angles alone") {}
  SUBCASE("lengths, too") { isometry = 0.03; }
  const ConformalTriangle triangle(corners, isometry);
  const ConformalTriangle::Corners uv = mapped(2, 0.7, 0.3);
  ConformalTriangle::Gradient gradient, ahead, behind;
  ConformalTriangle::Hessian hessian, unused;
  triangle.derivatives(uv, gradient, hessian);
  constexpr double h = 1e-6;
  ConformalTriangle::Hessian curved;
  for (int k = 0; k < 6; ++k) {
    ConformalTriangle::Corners up = uv, down = uv;
    (k % 2 ? up[k / 2].v : up[k / 2].u) += h;
    (k % 2 ? down[k / 2].v : down[k / 2].u) -= h;
    CHECK(gradient[k] ==
          doctest::Approx((triangle.value(up) - triangle.value(down)) / (2 * h)).epsilon(1e-6));
    triangle.derivatives(up, ahead, unused);
    triangle.derivatives(down, behind, unused);
    curved.col(k) = (ahead - behind) / (2 * h);
  }
  const auto least = [](const ConformalTriangle::Hessian& m) {
    return Eigen::SelfAdjointEigenSolver<ConformalTriangle::Hessian>(m).eigenvalues()[0];
  };
  CHECK(least(curved) < -0.1);  // the energy itself does not curve up everywhere
  CHECK(least(hessian) > -1e-9);
  CHECK(least(hessian - (curved + curved.transpose()) / 2) > -1e-6);
}

}  // namespace rimline
