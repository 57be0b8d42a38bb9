// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/insert_near.h"

#include <algorithm>
#include <vector>

#include "mesh/foot.h"

namespace rimline {
namespace {

constexpr double farthest = 0.8;  // spacings: noise and views that do not fit leave less
constexpr int looked_at = 12;     // neighbours: two rings of them

// The triangle that the point lies over, or none.
Index triangle_under(const EditableMesh& mesh, const Neighbours& neighbours, std::span<const double> spacing,
                     Index v) {
  const Points points = mesh.points();
  Foot nearest;
  Index at = none;
  for (const Index near : neighbours.of(v, std::min(neighbours.k, looked_at))) {
    for (const Index t : mesh.star(near)) {
      const Triangle& x = mesh.triangle(t);
      const Foot foot = foot_on(points[v], {points[x[0]], points[x[1]], points[x[2]]});
      if (foot.squared >= nearest.squared) continue;
      nearest = foot;
      at = t;
    }
  }
  if (at == none) return none;
  const Triangle& x = mesh.triangle(at);
  const double reach = farthest * (spacing[x[0]] + spacing[x[1]] + spacing[x[2]]) / 3;
  if (nearest.squared > reach * reach) return none;
  if (nearest.corner < 0) return at;
  const Index a = x[next(nearest.corner)], b = x[previous(nearest.corner)];
  return mesh.across(at, a, b) == none ? none : at;
}

void split(EditableMesh& mesh, Index t, Index v) {
  const Triangle x = mesh.triangle(t);
  mesh.remove(t);
  for (int c = 0; c < 3; ++c) mesh.add({x[c], x[next(c)], v});
}

}  // namespace

void insert_near(EditableMesh& mesh, const Neighbours& neighbours, std::span<const double> spacing) {
  std::vector<Index> waiting;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (mesh.star(v).empty()) waiting.push_back(v);
  }
  for (std::size_t before = waiting.size() + 1; waiting.size() < before;) {
    before = waiting.size();
    std::erase_if(waiting, [&](Index v) {
      const Index t = triangle_under(mesh, neighbours, spacing, v);
      if (t != none) split(mesh, t, v);
      return t != none;
    });
  }
}

}  // namespace rimline
