// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/crossings.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

namespace rimline::bench {
namespace {

Eigen::Vector3d vector_of(Point p) { return {p.x, p.y, p.z}; }

Eigen::Vector3d normal_at(const Case& c, std::span<const Index> ends) {
  std::vector<Index> ids(ends.begin(), ends.end());
  for (const Index end : ends) {
    const auto around = c.neighbours.of(end);
    ids.insert(ids.end(), around.begin(), around.end());
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index id : ids) mean += vector_of(c.points[id]);
  mean /= static_cast<double>(ids.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Index id : ids) {
    const Eigen::Vector3d d = vector_of(c.points[id]) - mean;
    covariance += d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
}

// Do segments a-b and c-d cross in their inner parts, seen along n; and how far apart are they there?
bool cross_along(const std::array<Eigen::Vector3d, 4>& p, const Eigen::Vector3d& n, double reach) {
  const Eigen::Vector3d ab = p[1] - p[0], cd = p[3] - p[2], ac = p[2] - p[0];
  const double whole = ab.cross(cd).dot(n);
  const double s = ac.cross(cd).dot(n) / whole, t = ac.cross(ab).dot(n) / whole;
  constexpr double margin = 1e-9;  // edges that only touch do not cross
  if (!(s > margin && s < 1 - margin && t > margin && t < 1 - margin)) return false;
  return std::abs((ac + t * cd - s * ab).dot(n)) < reach;
}

bool cross(const Case& c, const Edge& e, const Edge& f) {
  if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
  const std::array<Index, 4> ends{e.a, e.b, f.a, f.b};
  std::array<Eigen::Vector3d, 4> p;
  double reach = 0;
  for (int i = 0; i < 4; ++i) {
    p[i] = vector_of(c.points[ends[i]]);
    reach = std::max(reach, c.spacing[ends[i]]);
  }
  return cross_along(p, normal_at(c, ends), reach);
}

Point middle(const Case& c, const Edge& e) { return 0.5 * (c.points[e.a] + c.points[e.b]); }
double length(const Case& c, const Edge& e) { return distance(c.points[e.a], c.points[e.b]); }

}  // namespace

// Edges sorted by the x of their left end: only those that overlap in x, then in y and z, are looked at.
std::size_t count_crossings(const Case& c, const EdgeSet& loops) {
  struct Span {
    double low, high;
    Edge edge;
  };
  std::vector<Span> spans;
  for (const Edge& e : loops) {
    const double x = middle(c, e).x, half = length(c, e) / 2 + std::max(c.spacing[e.a], c.spacing[e.b]) / 2;
    spans.push_back({x - half, x + half, e});
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& s, const Span& t) { return std::pair(s.low, s.edge) < std::pair(t.low, t.edge); });
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Edge& e = spans[i].edge;
    for (std::size_t j = i + 1; j < spans.size() && spans[j].low <= spans[i].high; ++j) {
      const Edge& f = spans[j].edge;
      const double reach = (length(c, e) + length(c, f)) / 2 + std::max(c.spacing[e.a], c.spacing[f.a]);
      if (squared_distance(middle(c, e), middle(c, f)) > reach * reach) continue;
      crossings += cross(c, e, f);
    }
  }
  return crossings;
}

}  // namespace rimline::bench
