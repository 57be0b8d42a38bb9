// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/sheet.h"

#include <cmath>

namespace rimline::exact {
namespace {

bool has_directed_edge(const Triangle& t, Index a, Index b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

// All triangles of one component, from its first; each is turned to agree with the one it was reached from.
std::vector<Index> walk_sheet(Complex& complex, const Kept& kept, Index first, Index sheet,
                              std::vector<Index>& of_triangle, bool& orientable) {
  std::vector<Index> members{first};
  of_triangle[first] = sheet;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Triangle t = complex.triangle(members[i]);
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      const Index other = complex.across(members[i], k);
      if (other == none || !kept[other]) continue;
      const bool agrees = !has_directed_edge(complex.triangle(other), a, b);
      if (of_triangle[other] == none) {
        if (!agrees) complex.flip(other);
        of_triangle[other] = sheet;
        members.push_back(other);
      } else if (!agrees) {
        orientable = false;
      }
    }
  }
  return members;
}

bool faces_up(const Complex& complex, const std::vector<Index>& members) {
  const Points p = complex.points();
  Point sum;
  double area = 0;
  for (const Index t : members) {
    const Triangle& x = complex.triangle(t);
    const Point normal = cross(p[x[1]] - p[x[0]], p[x[2]] - p[x[0]]);
    sum = sum + normal;
    area += norm(normal);
  }
  for (const double c : {sum.z, sum.y, sum.x}) {
    if (std::abs(c) > 1e-3 * area) return c > 0;
  }
  return true;
}

}  // namespace

Sheets orient_sheets(Complex& complex, const Kept& kept) {
  Sheets sheets;
  sheets.of_triangle.assign(complex.size(), none);
  for (Index t = 0; t < complex.size(); ++t) {
    if (!kept[t] || sheets.of_triangle[t] != none) continue;
    bool orientable = true;
    const auto members = walk_sheet(complex, kept, t, sheets.count(), sheets.of_triangle, orientable);
    if (!faces_up(complex, members)) {
      for (const Index m : members) complex.flip(m);
    }
    sheets.orientable.push_back(orientable);
  }
  return sheets;
}

}  // namespace rimline::exact
