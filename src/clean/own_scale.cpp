// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/own_scale.h"

#include <algorithm>
#include <vector>

#include "base/model_clean.h"
#include "clean/surface_fit.h"

namespace rimline {
namespace {

// Points within a radius of a point, thinned to a least distance.
struct Thinned {
  Point centre;
  double radius, apart;
  std::vector<Index> ids;

  void add(Index id, Points points) {
    const Point p = points[id];
    const double d = distance(p, centre);
    if (d == 0 || d > radius) return;
    for (const Index other : ids) {
      if (distance(points[other], p) < apart) return;
    }
    ids.push_back(id);
  }
};

// One point of each small box, all points of the others.
void gather(const KdTree& tree, std::size_t at, Points points, Thinned& thinned) {
  const KdTree::Node& node = tree.node(at);
  const Bounds here{thinned.centre, thinned.centre};
  if (squared_gap(node.bounds, here) > thinned.radius * thinned.radius) return;
  if (distance(node.bounds.low, node.bounds.high) < thinned.apart)
    return thinned.add(tree.id[(node.begin + node.end) / 2], points);
  if (node.is_leaf()) {
    for (std::uint32_t i = node.begin; i < node.end; ++i) thinned.add(tree.id[i], points);
    return;
  }
  gather(tree, node.child, points, thinned);
  gather(tree, node.child + 1, points, thinned);
}

}  // namespace

bool fits_at_own_scale(const KdTree& tree, Points points, const std::vector<double>& spacing, Index self,
                       double nearest) {
  Thinned thinned{points[self], model::own_radius * nearest, model::own_apart * nearest, {}};
  gather(tree, KdTree::root, points, thinned);
  std::ranges::sort(thinned.ids, {}, [&](Index j) { return squared_distance(points[self], points[j]); });
  std::vector<Point> offsets;
  bool has_alike = false;
  for (const Index j : thinned.ids) {
    offsets.push_back((1 / nearest) * (points[j] - points[self]));
    has_alike = has_alike ||
                (spacing[j] > model::own_alike * nearest && norm(offsets.back()) < model::own_alike_near);
  }
  const SurfaceFit fit = fit_without(offsets);
  return fit.nearest < 1e300 && fit.height < model::own_height && (has_alike || fit.gap < model::own_gap);
}

}  // namespace rimline
