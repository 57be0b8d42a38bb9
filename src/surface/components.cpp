// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/components.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

// Sums over triangles of a component, turned to agree.
struct Facing {
  Index component;
  Point normal = {};  // twice the area long
  double area = 0;    // twice
};

// Of triangles in a row that are of one component.
std::vector<Facing> facing_of_rows(const TriangleSet& set, const Components& components, Index begin,
                                   Index end) {
  std::vector<Facing> rows;
  for (Index t = begin; t < end; ++t) {
    const Index own = components.of_triangle[t];
    if (own == none) continue;
    if (rows.empty() || rows.back().component != own) rows.push_back({own});
    const Point normal = triangle_normal(set.points(), set.triangle(t));
    rows.back().normal = rows.back().normal + (1.0 - 2.0 * components.turned[t]) * normal;
    rows.back().area += norm(normal);
  }
  return rows;
}

std::vector<Facing> facing_of_components(const TriangleSet& set, const Components& components,
                                         const Run& run) {
  constexpr std::size_t in_slice = 8192;  // [speed]
  const auto count = static_cast<std::size_t>(set.size());
  std::vector<std::vector<Facing>> slices((count + in_slice - 1) / in_slice);
  parallel_tasks(slices.size(), Stage::Loops, run, [&](std::size_t s) {
    slices[s] = facing_of_rows(set, components, static_cast<Index>(s * in_slice),
                               static_cast<Index>(std::min(count, (s + 1) * in_slice)));
  });
  run.check_cancel();
  std::vector<Facing> sums(components.count());
  for (const std::vector<Facing>& rows : slices) {
    for (const Facing& row : rows) {
      sums[row.component].normal = sums[row.component].normal + row.normal;
      sums[row.component].area += row.area;
    }
  }
  return sums;
}

bool faces_up(const Facing& sum) {
  for (const double c : {sum.normal.z, sum.normal.y, sum.normal.x}) {
    if (std::abs(c) > 1e-3 * sum.area) return c > 0;  // [guard] nearly 0 is no direction
  }
  return true;
}

}  // namespace

Components find_components(const TriangleSet& set, const Selection& selected, const Run& run) {
  Components components = find_components(set.mesh(), selected, run);
  const std::vector<Facing> facing = facing_of_components(set, components, run);
  parallel_for_each(components.turned.size(), Stage::Loops, run, [&](Index t) {
    const Index own = components.of_triangle[t];
    if (own != none && !faces_up(facing[own])) components.turned[t] ^= 1;
  });
  return components;
}

TriangleSet turn_over(TriangleSet set, const std::vector<std::uint8_t>& marked, const Run& run) {
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) { set.flip_if(t, marked[t] != 0); });
  return set;
}

}  // namespace rimline
