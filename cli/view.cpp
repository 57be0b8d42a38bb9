// SPDX-License-Identifier: GPL-3.0-or-later
#include "view.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

namespace rimline::cli {
namespace {

struct Principal {
  Point centre;
  Point box_centre;
  std::array<Point, 3> axes;         // of the largest spread first
  std::array<double, 3> deviations;  // standard deviation along each
};

Point box_centre(Points points) {
  if (points.empty()) return {};
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return 0.5 * (low + high);
}

Principal principal_axes(Points points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Point p : points) sum += Eigen::Vector3d(p.x, p.y, p.z);
  const double count = std::max<double>(1, static_cast<double>(points.size()));
  const Eigen::Vector3d mean = sum / count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Point p : points) {
    const Eigen::Vector3d d = Eigen::Vector3d(p.x, p.y, p.z) - mean;
    covariance += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / count);
  Principal result;
  result.centre = {mean.x(), mean.y(), mean.z()};
  result.box_centre = box_centre(points);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(2 - i);
    result.axes[i] = {axis.x(), axis.y(), axis.z()};
    result.deviations[i] = std::sqrt(std::max(0.0, solver.eigenvalues()[2 - i]));
  }
  return result;
}

Point unit(Point p) { return (1 / norm(p)) * p; }

// Any unit vector at a right angle to a unit vector.
Point across(Point axis) {
  const Point candidate = std::abs(axis.x) < 0.7 ? Point{1, 0, 0} : Point{0, 1, 0};
  return unit(cross(axis, candidate));
}

View look(Point toward, Point up) {
  View view;
  view.toward = unit(toward);
  const Point side = cross(up, view.toward);
  view.right = norm(side) > 1e-6 ? unit(side) : across(view.toward);
  view.up = cross(view.toward, view.right);
  return view;
}

// From the middle of the points to the middle of the longest loop.
Point opening(Points points, const std::vector<Loop>& loops, Point centre) {
  const auto longest = std::max_element(loops.begin(), loops.end(),
                                        [](const Loop& a, const Loop& b) { return a.length < b.length; });
  if (longest == loops.end() || longest->points.empty()) return {};
  Point sum;
  for (const Index id : longest->points) sum = sum + points[static_cast<std::size_t>(id)];
  return (1.0 / static_cast<double>(longest->points.size())) * sum - centre;
}

// The horizontal direction to look from: the front where there is one, else where the points are dense, which
// is where the detail is (the face of a head), else along the longest axis.
Point best_side(const Principal& principal, Point up, Point front) {
  const auto level = [up](Point p) { return p - dot(p, up) * up; };
  if (const Point side = level(front); norm(side) > 0.3) return unit(side);
  const Point dense = level(principal.centre - principal.box_centre);
  if (norm(dense) > 0.05 * principal.deviations[0]) return unit(dense);
  const Point longest = level(principal.axes[0]);
  return norm(longest) > 1e-3 ? unit(longest) : across(up);
}

// Mostly from the side, turned away from the axes and a little from above.
View standing(const Principal& principal, Point up, Point front) {
  const Point side = best_side(principal, up, front);
  return look(0.8 * side + 0.45 * cross(up, side) + 0.28 * up, up);
}

// Away from the opening; along a principal axis where it nearly is.
Point upright(const Principal& principal, Point open) {
  const Point up = unit(-1.0 * open);
  for (const Point axis : principal.axes) {
    if (std::abs(dot(axis, up)) > 0.9) return dot(axis, up) > 0 ? axis : -1.0 * axis;
  }
  return up;
}

// Down on the flat side, as one looks at a table.
View lying(const Principal& principal, Point normal) {
  Point back = principal.axes[1];
  if (back.z < 0 || (back.z == 0 && back.y < 0)) back = -1.0 * back;
  const Point side = cross(back, normal);
  return look(0.78 * normal - 0.55 * back + 0.3 * side, back);
}

}  // namespace

View choose_view(Points points, const std::vector<Loop>& loops, Point front, std::optional<Point> up) {
  std::vector<Point> finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), is_finite);
  const Principal principal = principal_axes(finite);
  const Point open = opening(points, loops, principal.centre);
  const auto& spread = principal.deviations;
  const bool sheet = spread[2] < 0.3 * spread[1];
  Point normal = principal.axes[2];
  if (dot(normal, norm(front) > 0 ? front : Point{0, 0, 1}) < 0) normal = -1.0 * normal;
  const Point outside = norm(front) > 0 ? unit(front) : Point{};
  if (up) {
    const Point given = unit(*up);
    if (sheet && std::abs(dot(normal, given)) > 0.7) return lying(principal, normal);
    return standing(principal, given, sheet ? normal : outside);
  }
  if (sheet) return lying(principal, normal);
  if (norm(open) > 0.5 * spread[2]) return standing(principal, upright(principal, open), {});
  return standing(principal, {0, 0, 1}, outside);
}

}  // namespace rimline::cli
