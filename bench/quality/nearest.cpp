// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/nearest.h"

#include <nanoflann.hpp>

namespace rimline::bench {

struct NearestPoint::Tree {
  using Metric = nanoflann::L2_Simple_Adaptor<double, Tree>;
  using Index3 = nanoflann::KDTreeSingleIndexAdaptor<Metric, Tree, 3, Index>;

  explicit Tree(std::vector<Point> given) : points(std::move(given)), index(3, *this) { index.buildIndex(); }

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t dim) const {
    const Point& p = points[i];
    return dim == 0 ? p.x : dim == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  std::vector<Point> points;
  Index3 index;
};

NearestPoint::NearestPoint(std::vector<Point> points) : tree_(std::make_unique<Tree>(std::move(points))) {}
NearestPoint::~NearestPoint() = default;
NearestPoint::NearestPoint(NearestPoint&&) noexcept = default;

NearestPoint::Found NearestPoint::to(Point place) const {
  const auto found = to(place, 1);
  return found.empty() ? Found{} : found.front();
}

std::vector<NearestPoint::Found> NearestPoint::to(Point place, std::size_t count) const {
  std::vector<Index> ids(count);
  std::vector<double> squared(count);
  const double query[3] = {place.x, place.y, place.z};
  const std::size_t got =
      tree_->points.empty() ? 0 : tree_->index.knnSearch(query, count, ids.data(), squared.data());
  std::vector<Found> found;
  for (std::size_t i = 0; i < got; ++i) found.push_back({ids[i], std::sqrt(squared[i])});
  return found;
}

}  // namespace rimline::bench
