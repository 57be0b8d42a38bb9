// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/neighbours.h"

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>
#include <string>
#include <tuple>

#include "parallel.h"

namespace rimline {
namespace {

struct PointsAdaptor {
  Points points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    const Point& p = points[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointsAdaptor>,
                                                   PointsAdaptor, 3, Index>;

// The k best of what the tree offers, kept sorted. Ties are settled here and not by the order in which the
// tree is walked; for that the tree must offer points at exactly the worst distance too, hence nextafter.
class NearestSet {
 public:
  using DistanceType = double;

  NearestSet(Points points, Index self, std::size_t k, Index* ids, double* squared)
      : points_(points), self_(self), k_(k), ids_(ids), squared_(squared) {}

  std::size_t size() const { return count_; }
  bool full() const { return count_ == k_; }
  double worstDist() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return full() ? std::nextafter(squared_[k_ - 1], infinity) : infinity;
  }
  bool addPoint(double squared, Index id) {
    if (id == self_ || (full() && !before(squared, id, k_ - 1))) return true;
    std::size_t at = full() ? k_ - 1 : count_++;
    for (; at > 0 && before(squared, id, at - 1); --at) {
      ids_[at] = ids_[at - 1];
      squared_[at] = squared_[at - 1];
    }
    ids_[at] = id;
    squared_[at] = squared;
    return true;
  }

 private:
  bool before(double squared, Index id, std::size_t slot) const {
    if (squared != squared_[slot]) return squared < squared_[slot];
    const Point &a = points_[id], &b = points_[ids_[slot]];
    return std::tie(a.x, a.y, a.z, id) < std::tie(b.x, b.y, b.z, ids_[slot]);
  }

  Points points_;
  Index self_;
  std::size_t k_;
  std::size_t count_ = 0;
  Index* ids_;
  double* squared_;
};

}  // namespace

Neighbours find_neighbours(Points points, int k, const Run& run) {
  if (points.size() < 2) {
    throw Error(ErrorCode::TooFewPoints,
                "neighbours need at least 2 points, there are " + std::to_string(points.size()));
  }
  Neighbours result;
  result.k = static_cast<int>(std::min<std::size_t>(k, points.size() - 1));
  result.ids.resize(points.size() * result.k);
  result.distance.resize(points.size() * result.k);

  run.progress(Stage::Neighbours, 0, points.size());
  const PointsAdaptor adaptor{points};
  const KdTree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  parallel_for_each(points.size(), Stage::Neighbours, run, [&](Index i) {
    const std::size_t at = static_cast<std::size_t>(i) * result.k;
    NearestSet nearest(points, i, result.k, result.ids.data() + at, result.distance.data() + at);
    const double query[3] = {points[i].x, points[i].y, points[i].z};
    tree.findNeighbors(nearest, query, nanoflann::SearchParams());
    for (int j = 0; j < result.k; ++j) result.distance[at + j] = std::sqrt(result.distance[at + j]);
  });
  return result;
}

std::vector<double> local_spacing(const Neighbours& neighbours) {
  const int nearest = std::min(6, neighbours.k);
  std::vector<double> spacing(neighbours.size());
  for (Index i = 0; i < neighbours.size(); ++i) {
    double sum = 0;
    for (int j = 0; j < nearest; ++j) sum += neighbours.distances_of(i)[j];
    spacing[i] = sum / nearest;
  }
  return spacing;
}

}  // namespace rimline
