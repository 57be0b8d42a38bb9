// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/frame.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "shapes.h"

namespace rimline {
namespace {

struct Solved {
  Point normal, middle, longest;
  double lambda[3];
};

// By a general eigen-solver, or by Eigen's closed form.
Solved solve(Points points, std::span<const Index> others, Index point, bool closed_form = false) {
  Eigen::MatrixXd rows(others.size() + 1, 3);
  const auto set = [&](Eigen::Index row, Point p) { rows.row(row) << p.x, p.y, p.z; };
  set(0, points[point]);
  for (std::size_t i = 0; i < others.size(); ++i) set(static_cast<Eigen::Index>(i) + 1, points[others[i]]);
  const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred.transpose() * centred);
  if (closed_form) solver.computeDirect(centred.transpose() * centred);
  const auto column = [&](int c) {
    const Eigen::Vector3d v = solver.eigenvectors().col(c);
    return Point{v.x(), v.y(), v.z()};
  };
  return {column(0),
          column(1),
          column(2),
          {solver.eigenvalues()[0], solver.eigenvalues()[1], solver.eigenvalues()[2]}};
}

void check_frame(const Frame& frame, const Solved& expected) {
  const auto [normal, middle, longest, lambda] = expected;
  CHECK(distance(cross(frame.normal, frame.u), frame.v) < 1e-14);
  CHECK(norm(frame.normal) == doctest::Approx(1).epsilon(1e-14));
  CHECK(norm(frame.u) == doctest::Approx(1).epsilon(1e-14));
  CHECK(std::abs(dot(frame.u, frame.normal)) < 1e-14);
  CHECK(frame.thickness == doctest::Approx(lambda[0] / lambda[1]).epsilon(1e-6).scale(1e-6));
  // Vectors are as sure as their eigenvalue is apart from the others.
  if (lambda[1] - lambda[0] > 1e-3 * lambda[2]) CHECK(norm(cross(frame.normal, normal)) < 1e-9);
  if (lambda[2] - lambda[1] > 1e-3 * lambda[2]) CHECK(norm(cross(frame.u, longest)) < 1e-9);
}

// A bent disc; a number of points that leaves lanes over.
std::vector<Point> bent() {
  auto points = shapes::disc(12, 0.3).points;
  for (Point& p : points) p.z += 0.02 * p.x * p.x - 0.01 * p.x * p.y;
  points = shapes::turned(points, 0.4, 0.2, 1);
  for (Point& p : points) p = p + Point{30, -20, 10};
  while (points.size() % 8 != 5) points.pop_back();
  return points;
}

TEST_CASE("frames are the principal directions of a point and its 12 nearest") {
  const auto points = bent();
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto frames = fit_frames(points, neighbours, {});
  REQUIRE(frames.size() == points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const Solved twelve = solve(points, neighbours.of(i, 12), i);
    if (twelve.lambda[1] < 0.11 * twelve.lambda[2]) continue;  // nearly a line
    check_frame(frames[i], twelve);
    check_frame(fit_frame(points, neighbours.of(i, 12), i), twelve);
  }
}

TEST_CASE("the signs of axes are those of Eigen's closed form") {
  auto points = bent();
  for (Point& p : points) p.x *= 1.5;  // no axes of one length
  const Neighbours neighbours = find_neighbours(points, 12, {});
  const auto frames = fit_frames(points, neighbours, {});
  std::size_t different = 0, asked = 0;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const auto [normal, middle, longest, lambda] = solve(points, neighbours.of(i), i, true);
    if (lambda[2] - lambda[1] < 0.05 * lambda[2]) continue;
    ++asked;
    different += dot(frames[i].normal, normal) < 0 || dot(frames[i].u, longest) < 0;
    const Frame alone = fit_frame(points, neighbours.of(i), i);
    different += dot(alone.normal, normal) < 0 || dot(alone.u, longest) < 0;
  }
  CHECK(asked > points.size() / 2);
  CHECK(different <= points.size() / 100);  // two products of one size, where rounding decides
}

TEST_CASE("frames on scan lines far apart are those of as many points as make a patch") {
  std::vector<Point> points;
  for (int row = 0; row < 12; ++row) {
    for (int i = 0; i < 60; ++i)
      points.push_back({0.11 * i + 0.001 * row * row, 1.0 * row, 0.02 * row * row});
  }
  const Neighbours neighbours = find_neighbours(points, 40, {});
  const auto frames = fit_frames(points, neighbours, {});
  std::size_t lines = 0;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    for (const int k : {12, 20, 40}) {
      const Solved fit = solve(points, neighbours.of(i, k), i);
      if (fit.lambda[1] < 0.1 * fit.lambda[2] && k < 40) continue;
      lines += k > 12;
      check_frame(frames[i], fit);
      break;
    }
  }
  CHECK(lines > points.size() / 2);
}

TEST_CASE("frames of a grid's points are the grid's plane exactly, of fewer points than asked for too") {
  for (const int width : {20, 3}) {
    std::vector<Point> grid;
    for (int i = 0; i < width * width; ++i) grid.push_back({0.5 * (i % width), 0.25 * (i / width), 3});
    for (const Frame& frame : fit_frames(grid, find_neighbours(grid, 40, {}), {})) {
      CHECK(frame.normal.x == 0);
      CHECK(frame.normal.y == 0);
      CHECK(std::abs(frame.normal.z) == doctest::Approx(1).epsilon(1e-15));
      CHECK(frame.thickness == 0);
    }
  }
}

}  // namespace
}  // namespace rimline
