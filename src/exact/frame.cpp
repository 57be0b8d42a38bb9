// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/frame.h"

#include <Eigen/Eigenvalues>

#include "parallel.h"

namespace rimline::exact {
namespace {

Eigen::Vector3d to_eigen(Point p) { return {p.x, p.y, p.z}; }
Point from_eigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Matrix3d covariance(Points points, Index self, std::span<const Index> ids) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index id : ids) mean += to_eigen(points[id] - points[self]);
  mean /= static_cast<double>(ids.size() + 1);
  Eigen::Matrix3d sum = mean * mean.transpose();
  for (const Index id : ids) {
    const Eigen::Vector3d d = to_eigen(points[id] - points[self]) - mean;
    sum += d * d.transpose();
  }
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
  std::vector<Frame> frames(points.size());
  parallel_for_each(points.size(), Stage::Boundary, run,
                    [&](Index i) { frames[i] = fit_frame(points, neighbours, i); });
  return frames;
}

}  // namespace rimline::exact
