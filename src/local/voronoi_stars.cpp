// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/voronoi_stars.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "local/principal_axes.h"
#include "local/voronoi_cell.h"

namespace rimline {
namespace {

void add(Covariance& c, Point d) {
  c.xx += d.x * d.x;
  c.xy += d.x * d.y;
  c.xz += d.x * d.z;
  c.yy += d.y * d.y;
  c.yz += d.y * d.z;
  c.zz += d.z * d.z;
}

struct Frame {
  Point normal, u, v;
};

Frame make_frame(Point normal) {
  const Point axis = std::abs(normal.x) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};  // [guard]
  const Point side = cross(normal, axis);
  const Point u = (1 / norm(side)) * side;
  return {normal, u, cross(normal, u)};
}

class StarFinder {
 public:
  StarFinder(Points points, const Neighbours& neighbours, std::span<const Index> label,
             const StarOptions& options)
      : points_(points), neighbours_(neighbours), label_(label), options_(options) {}

  Point normal(Index i) const {
    const std::span<const Index> near = neighbours_.of(i, std::min(options_.normal_k, neighbours_.k));
    Point mean{};
    for (const Index j : near) mean = mean + (points_[j] - points_[i]);
    mean = (1.0 / static_cast<double>(near.size() + 1)) * mean;
    Covariance covariance;
    add(covariance, mean);
    for (const Index j : near) add(covariance, points_[j] - points_[i] - mean);
    return principal_axes(covariance).v[0];
  }

  // The cell of point i; positions are laid out by direction in the tangent plane and true distance.
  void cell(Index i, Point normal, VoronoiCell& cell) const {
    const Frame frame = make_frame(normal);
    const std::span<const Index> ids = neighbours_.of(i);
    cell.start(distance(points_[i], points_[ids.back()]));
    for (const Index id : ids) {
      const Point d = points_[id] - points_[i];
      const double far = norm(d);
      if (cell.settled(far)) break;
      if (!label_.empty() && label_[id] != label_[i]) continue;
      const double u = dot(d, frame.u), v = dot(d, frame.v);
      const double flat = std::sqrt(u * u + v * v);
      if (flat < options_.steepest * far) continue;
      const double stretch = far / flat;
      cell.clip(stretch * u, stretch * v, id);
    }
  }

 private:
  Points points_;
  const Neighbours& neighbours_;
  std::span<const Index> label_;
  StarOptions options_;
};

}  // namespace

Stars find_stars(Points points, const Neighbours& neighbours, std::span<const Index> label,
                 const StarOptions& options, const Run& run) {
  constexpr std::size_t slice = 1024;  // [speed]
  struct Part {
    std::vector<Index> neighbours, counts;
    std::vector<double> weights;
  };
  const std::size_t n = points.size();
  const StarFinder finder(points, neighbours, label, options);
  Stars stars;
  stars.normals.resize(n);
  std::vector<Part> parts((n + slice - 1) / slice);
  parallel_tasks(parts.size(), Stage::Parameterize, run, [&](std::size_t k) {
    Part& part = parts[k];
    VoronoiCell cell;
    for (std::size_t i = k * slice; i < std::min(n, (k + 1) * slice); ++i) {
      stars.normals[i] = finder.normal(static_cast<Index>(i));
      finder.cell(static_cast<Index>(i), stars.normals[i], cell);
      const std::size_t before = part.neighbours.size();
      cell.edges([&](Index id, double weight) {
        part.neighbours.push_back(id);
        part.weights.push_back(weight);
      });
      part.counts.push_back(static_cast<Index>(part.neighbours.size() - before));
    }
  });
  stars.offsets.reserve(n + 1);
  for (const Part& part : parts) {
    for (const Index count : part.counts) stars.offsets.push_back(stars.offsets.back() + count);
    stars.neighbours.insert(stars.neighbours.end(), part.neighbours.begin(), part.neighbours.end());
    stars.weights.insert(stars.weights.end(), part.weights.begin(), part.weights.end());
  }
  return stars;
}

}  // namespace rimline
