// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

namespace rimline::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

// Two triangles as many as they share vertices: none, one or two.
class Pairs {
 public:
  Pairs(Points points, const std::vector<Triangle>& mesh) : mesh_(mesh) {
    places_.reserve(points.size());
    for (const Point& p : points) places_.emplace_back(p.x, p.y, p.z);
  }

  Kernel::Triangle_3 triangle(std::size_t i) const {
    const Triangle& t = mesh_[i];
    return {places_[t[0]], places_[t[1]], places_[t[2]]};
  }

  bool intersect(std::size_t i, std::size_t j) const {
    Triangle s = mesh_[i], t = mesh_[j];
    switch (bring_common_forward(s, t)) {
      case 0: return CGAL::do_intersect(triangle(i), triangle(j));
      case 1: return meet_beyond_vertex(s, t);
      case 2: return fold_over_edge(s, t);
      default: return true;  // the same triangle twice
    }
  }

 private:
  // Turns both so that what they share comes first, in the same order. Returns how many vertices that is.
  static int bring_common_forward(Triangle& s, Triangle& t) {
    int common = 0;
    for (int i = 0; i < 3; ++i) {
      const auto found = std::find(t.begin() + common, t.end(), s[i]);
      if (found == t.end()) continue;
      std::iter_swap(t.begin() + common, found);
      std::swap(s[common], s[i]);
      ++common;
    }
    return common;
  }

  // Sharing vertex s[0]: they meet elsewhere where the edge opposite to it, of one, meets the other.
  bool meet_beyond_vertex(const Triangle& s, const Triangle& t) const {
    const auto at = [&](Index id) { return places_[id]; };
    const Kernel::Segment_3 of_s(at(s[1]), at(s[2])), of_t(at(t[1]), at(t[2]));
    return CGAL::do_intersect(of_s, Kernel::Triangle_3(at(t[0]), at(t[1]), at(t[2]))) ||
           CGAL::do_intersect(of_t, Kernel::Triangle_3(at(s[0]), at(s[1]), at(s[2])));
  }

  // Sharing an edge: they overlap where they lie in one plane on the same side of it.
  bool fold_over_edge(const Triangle& s, const Triangle& t) const {
    const auto &a = places_[s[0]], &b = places_[s[1]], &c = places_[s[2]], &d = places_[t[2]];
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  const std::vector<Triangle>& mesh_;
  std::vector<Kernel::Point_3> places_;
};

}  // namespace

std::size_t count_self_intersections(Points points, const std::vector<Triangle>& mesh) {
  const Pairs pairs(points, mesh);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto triangle = pairs.triangle(i);
    if (!triangle.is_degenerate()) boxes.emplace_back(triangle.bbox(), i);
  }
  std::size_t count = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    count += pairs.intersect(a.info(), b.info());
  });
  return count;
}

}  // namespace rimline::bench
