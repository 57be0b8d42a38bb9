// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/frame.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "first_touch.h"
#include "parallel.h"

namespace rimline::exact {
namespace {

Point from_eigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// Of the points and the one they are the neighbours of: sums of squares, only the lower triangle of which is
// read.
Eigen::Matrix3d covariance(Points points, Index self, std::span<const Index> ids) {
  constexpr std::size_t most = 40;
  const Point p = points[self];
  std::array<Point, most> room;
  std::vector<Point> more;
  Point* const offset = ids.size() <= most ? room.data() : (more.resize(ids.size()), more.data());
  Point mean;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    offset[i] = points[ids[i]] - p;
    mean = mean + offset[i];
  }
  const double count = static_cast<double>(ids.size() + 1);
  mean = {mean.x / count, mean.y / count, mean.z / count};
  double xx = mean.x * mean.x, xy = mean.x * mean.y, xz = mean.x * mean.z;
  double yy = mean.y * mean.y, yz = mean.y * mean.z, zz = mean.z * mean.z;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Point d = offset[i] - mean;
    xx += d.x * d.x, xy += d.x * d.y, xz += d.x * d.z;
    yy += d.y * d.y, yz += d.y * d.z, zz += d.z * d.z;
  }
  Eigen::Matrix3d sum;
  sum << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return sum;
}

Frame frame_of(const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver) {
  Frame frame;
  frame.normal = from_eigen(solver.eigenvectors().col(0));
  frame.u = from_eigen(solver.eigenvectors().col(2));
  frame.v = cross(frame.normal, frame.u);
  const double middle = solver.eigenvalues()[1];
  frame.thickness = middle > 0 ? std::max(0.0, solver.eigenvalues()[0] / middle) : 0;
  return frame;
}

}  // namespace

Frame fit_frame(Points points, const Neighbours& neighbours, Index point) {
  // Middle over largest eigenvalue below which the neighbours are a line rather than a patch.
  constexpr double line = 0.1;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  for (const int k : {12, 20, 40}) {
    solver.computeDirect(covariance(points, point, neighbours.of(point, std::min(k, neighbours.k))));
    if (solver.eigenvalues()[1] >= line * solver.eigenvalues()[2] || k >= neighbours.k) break;
  }
  return frame_of(solver);
}

Frame fit_frame(Points points, std::span<const Index> ids, Index point) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance(points, point, ids));
  return frame_of(solver);
}

std::vector<Frame> fit_frames(Points points, const Neighbours& neighbours, const Run& run) {
  std::vector<Frame> frames;
  resize_together(frames, points.size(), run);
  parallel_for_each(points.size(), Stage::Survey, run,
                    [&](Index i) { frames[i] = fit_frame(points, neighbours, i); });
  return frames;
}

}  // namespace rimline::exact
