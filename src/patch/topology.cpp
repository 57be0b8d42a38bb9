// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/topology.h"

#include <algorithm>
#include <tuple>

#include "base/union_find.h"
#include "base/vec.h"
#include "mesh/components.h"

namespace rimline {
namespace {

// Whether the cell of `point` has a corner between the sides towards a and b.
bool has_corner(const Stars& stars, Index point, Index a, Index b) {
  const std::span<const Index> star = stars[point];
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Index after = star[next_in(i, star.size())];
    if ((star[i] == a && after == b) || (star[i] == b && after == a)) return true;
  }
  return false;
}

// Edges with their triangles, without regard to orientation.
struct Side {
  Index a, b, triangle;  // a < b
  friend bool operator<(const Side& s, const Side& t) {
    return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
  }
};

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index a = triangles[t][c], b = triangles[t][next(c)];
      sides.push_back({std::min(a, b), std::max(a, b), t});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

bool same_edge(const Side& s, const Side& t) { return s.a == t.a && s.b == t.b; }

// The triangles of the largest edge-connected component.
Triangulation largest_part(Triangulation mesh) {
  const Components components = find_components(mesh);
  std::vector<Index> size(components.count(), 0);
  for (const Index c : components.of_triangle) ++size[c];
  const auto largest = static_cast<Index>(std::ranges::max_element(size) - size.begin());
  std::vector<Triangle> part;
  for (Index t = 0; t < mesh.size(); ++t) {
    if (components.of_triangle[t] == largest) part.push_back(mesh.triangles[t]);
  }
  return link_triangles(std::move(part));
}

Point unit_normal(Points points, const Triangle& t) {
  const Point n = triangle_normal(points, t);
  const double length = norm(n);
  return length > 0 ? (1 / length) * n : Point{};
}

// Cuts the mesh at edges where the triangles fold by more than 45 degrees: there the cells may have joined
// two close sheets, and a single such edge would make any surface one-sided. A well sampled strip is
// smoother.
bool is_orientable(Points points, const Triangulation& mesh) {
  constexpr double flat = 0.7;  // cosine
  Triangulation smooth = mesh;
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index u = mesh.adjacent[t][c];
      if (u == none) continue;
      const Triangle &x = mesh.triangles[t], &y = mesh.triangles[u];
      const bool agree = runs(y, x[previous(c)], x[next(c)]);
      const double cosine = dot(unit_normal(points, x), unit_normal(points, y));
      if ((agree ? cosine : -cosine) < flat) smooth.adjacent[t][c] = none;
    }
  }
  return std::ranges::count(find_components(smooth).orientable, 0) == 0;
}

}  // namespace

std::vector<Triangle> agreed_triangles(const Stars& stars) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < static_cast<Index>(stars.size()); ++i) {
    const std::span<const Index> star = stars[i];
    for (std::size_t k = 0; k < star.size(); ++k) {
      const Index a = star[k], b = star[k + 1 < star.size() ? k + 1 : 0];
      if (i < a && i < b && a != b && has_corner(stars, a, i, b) && has_corner(stars, b, i, a)) {
        triangles.push_back({i, a, b});
      }
    }
  }
  return triangles;
}

Topology find_topology(Points points, const Stars& stars) {
  const Index n = static_cast<Index>(stars.size());
  Topology topology;
  const Triangulation mesh = largest_part(link_triangles(agreed_triangles(stars)));
  const std::vector<Triangle>& triangles = mesh.triangles;
  topology.triangles = static_cast<Index>(triangles.size());
  if (triangles.empty()) return topology;
  const std::vector<Side> sides = sides_of(triangles);
  topology.orientable = is_orientable(points, mesh);
  // Euler's number, and one disc for each independent cycle of open edges.
  std::vector<char> used(n, 0), rim(n, 0);
  UnionFind rims(n);
  long long edges = 0, open = 0, vertices = 0, rim_vertices = 0, rim_parts = 0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    used[sides[s].a] = used[sides[s].b] = 1;
    if (s > 0 && same_edge(sides[s - 1], sides[s])) continue;
    ++edges;
    if (s + 1 < sides.size() && same_edge(sides[s], sides[s + 1])) continue;
    ++open;
    rim[sides[s].a] = rim[sides[s].b] = 1;
    rims.join(sides[s].a, sides[s].b);
  }
  for (Index v = 0; v < n; ++v) {
    vertices += used[v];
    rim_vertices += rim[v];
    rim_parts += rim[v] && rims.find(v) == v;
  }
  const long long discs = open - rim_vertices + rim_parts;
  const long long euler = vertices - edges + static_cast<long long>(triangles.size()) + discs;
  topology.genus = static_cast<int>((2 - euler) / 2);
  topology.coverage = static_cast<double>(vertices) / static_cast<double>(n);
  return topology;
}

}  // namespace rimline
