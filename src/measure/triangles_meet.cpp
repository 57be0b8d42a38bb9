// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/triangles_meet.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>

namespace rimline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Turns both so that what they share comes first, in the same order. Returns how many vertices that is.
int bring_common_forward(Triangle& s, Triangle& t) {
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

}  // namespace

bool triangles_meet(Points points, Triangle s, Triangle t) {
  const auto at = [&](Index id) { return Kernel::Point_3(points[id].x, points[id].y, points[id].z); };
  const int common = bring_common_forward(s, t);
  const Kernel::Triangle_3 first(at(s[0]), at(s[1]), at(s[2])), second(at(t[0]), at(t[1]), at(t[2]));
  if (first.is_degenerate() || second.is_degenerate()) return false;
  switch (common) {
    case 0: return CGAL::do_intersect(first, second);
    case 1:  // elsewhere where the edge opposite to the shared vertex, of one, meets the other
      return CGAL::do_intersect(Kernel::Segment_3(first[1], first[2]), second) ||
             CGAL::do_intersect(Kernel::Segment_3(second[1], second[2]), first);
    case 2:  // they overlap where they lie in one plane on the same side of the shared edge
      return CGAL::coplanar(first[0], first[1], first[2], second[2]) &&
             CGAL::coplanar_orientation(first[0], first[1], first[2], second[2]) == CGAL::POSITIVE;
    default: return true;  // the same triangle twice
  }
}

}  // namespace rimline
