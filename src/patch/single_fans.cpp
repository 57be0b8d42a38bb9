// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/single_fans.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>

namespace rimline {
namespace {

// An open edge of a fan: towards its far end, or from there.
struct End {
  Index to, triangle;
  bool leaves;
};

std::vector<End> ends_of(const EditableMesh& mesh, Index v, const Fan& fan) {
  if (fan.first == none) return {};
  const auto end = [&](Index to, Index t) { return End{to, t, mesh.runs(t, v, to)}; };
  return {end(fan.first, fan.triangles.front()), end(fan.last, fan.triangles.back())};
}

struct Bridge {
  Triangle triangle;
  double length;  // of its new edge
};

// The triangle between two consecutive open edges at v, where it fits the surface.
std::optional<Bridge> bridge_between(const EditableMesh& mesh, Index v, const End& a, const End& b,
                                     double spacing) {
  constexpr double longest = 3, level = 0.2, widest = -0.7;  // spacings; cosines of fold and angle
  if (a.leaves == b.leaves || a.to == b.to) return {};
  const Triangle t = a.leaves ? Triangle{a.to, v, b.to} : Triangle{b.to, v, a.to};
  if (!mesh.can_add(t)) return {};
  const Points points = mesh.points();
  const double length = distance(points[a.to], points[b.to]);
  if (length > longest * spacing) return {};
  const Point to_a = points[a.to] - points[v], to_b = points[b.to] - points[v];
  if (dot(to_a, to_b) < widest * norm(to_a) * norm(to_b)) return {};
  const Point normal = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  for (const Index beside : {a.triangle, b.triangle}) {
    const Point other = mesh.normal(beside);
    if (dot(normal, other) <= level * norm(normal) * norm(other)) return {};
  }
  return Bridge{t, length};
}

// Joins two of the fans. False where no triangle fits.
bool join_fans(EditableMesh& mesh, Index v, const std::vector<Fan>& fans, double spacing,
               std::vector<Index>& component) {
  std::optional<Bridge> best;
  Index sheet = none;
  for (std::size_t i = 0; i < fans.size(); ++i) {
    for (std::size_t j = i + 1; j < fans.size(); ++j) {
      if (component[fans[i].triangles.front()] != component[fans[j].triangles.front()]) continue;
      for (const End& a : ends_of(mesh, v, fans[i])) {
        for (const End& b : ends_of(mesh, v, fans[j])) {
          const auto found = bridge_between(mesh, v, a, b, spacing);
          if (!found || (best && best->length <= found->length)) continue;
          best = found;
          sheet = component[a.triangle];
        }
      }
    }
  }
  if (!best) return false;
  mesh.add(best->triangle);
  component.push_back(sheet);
  return true;
}

// Keeps the fan of most triangles; returns the vertices that lost some.
std::vector<Index> drop_lesser_fans(EditableMesh& mesh, const std::vector<Fan>& fans) {
  const auto most = std::ranges::max_element(
      fans, [](const Fan& a, const Fan& b) { return a.triangles.size() < b.triangles.size(); });
  std::vector<Index> touched;
  for (auto fan = fans.begin(); fan != fans.end(); ++fan) {
    if (fan == most) continue;
    for (const Index t : fan->triangles) {
      touched.insert(touched.end(), mesh.triangle(t).begin(), mesh.triangle(t).end());
      mesh.remove(t);
    }
  }
  return touched;
}

}  // namespace

void leave_single_fans(EditableMesh& mesh, std::span<const double> spacing) {
  std::vector<Index> component = mesh.components();
  std::queue<Index> open;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (mesh.star(v).size() > 1) open.push(v);
  }
  // Each vertex is bridged a few times at most, which bounds the loop.
  constexpr int most_bridges = 4;
  std::vector<char> bridges(mesh.vertices(), 0);
  for (; !open.empty(); open.pop()) {
    const Index v = open.front();
    for (std::vector<Fan> fans = mesh.fans(v); fans.size() > 1; fans = mesh.fans(v)) {
      if (bridges[v] < most_bridges && join_fans(mesh, v, fans, spacing[v], component)) {
        ++bridges[v];
        continue;
      }
      for (const Index w : drop_lesser_fans(mesh, fans)) {
        if (w != v) open.push(w);
      }
    }
  }
}

}  // namespace rimline
