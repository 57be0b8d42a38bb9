// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/open_mesh.h"

#include <algorithm>
#include <utility>

#include "base/union_find.h"
#include "base/vec.h"
#include "mesh/components.h"

namespace rimline {
namespace {

// Two corners that meet across a side, as 3 * triangle + corner.
using Joins = std::vector<std::pair<Index, Index>>;

// Vertices of a mesh whose corners are one where they are joined, numbered by their first corners.
struct Split {
  std::vector<Triangle> triangles;
  std::vector<Index> first_corner;  // of each vertex
};

Split split_vertices(std::size_t triangles, const Joins& joins) {
  UnionFind fans(3 * triangles);
  for (const auto& [a, b] : joins) fans.join(a, b);
  Split split;
  split.triangles.resize(triangles);
  std::vector<Index> number(3 * triangles, none);
  for (Index corner = 0; corner < static_cast<Index>(3 * triangles); ++corner) {
    Index& id = number[fans.find(corner)];
    if (id == none) {
      id = static_cast<Index>(split.first_corner.size());
      split.first_corner.push_back(corner);
    }
    split.triangles[corner / 3][corner % 3] = id;
  }
  return split;
}

// The loops of a mesh in which each vertex has one fan.
std::vector<Loop> loops_of(Points points, const Triangulation& mesh) {
  std::vector<Index> following(points.size(), none);
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (mesh.adjacent[t][c] == none) following[mesh.triangles[t][next(c)]] = mesh.triangles[t][previous(c)];
    }
  }
  std::vector<Loop> loops;
  for (Index v = 0; v < static_cast<Index>(following.size()); ++v) {
    if (following[v] == none) continue;
    Loop loop;
    for (Index at = v; at != none; at = std::exchange(following[at], none)) loop.points.push_back(at);
    if (loop.points.size() > 1) loop.points.pop_back();  // the first once more
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      loop.length += distance(points[loop.points[i]], points[loop.points[next_in(i, loop.points.size())]]);
    loops.push_back(std::move(loop));
  }
  std::ranges::stable_sort(loops, [](const Loop& a, const Loop& b) { return a.length > b.length; });
  for (std::size_t l = 1; l < loops.size(); ++l) loops[l].kind = LoopKind::Hole;
  return loops;
}

// Adds loops and genus to points and mesh.
OpenMesh finished(OpenMesh open) {
  open.loops = loops_of(open.points, open.mesh);
  long long rim = 0;
  for (const Loop& loop : open.loops) rim += static_cast<long long>(loop.points.size());
  const long long faces = open.mesh.size(), edges = (3 * faces + rim) / 2;
  const long long euler = open.vertices() - edges + faces;
  open.genus = static_cast<Index>((2 - euler - static_cast<long long>(open.loops.size())) / 2);
  return open;
}

}  // namespace

namespace {

// Whether two triangles run along an edge in the same direction.
bool runs_twice(const std::vector<Triangle>& triangles, std::size_t points) {
  std::vector<Index> offsets(points + 1, 0);
  for (const Triangle& t : triangles) {
    for (const Index v : t) ++offsets[v + 1];
  }
  for (std::size_t v = 0; v < points; ++v) offsets[v + 1] += offsets[v];
  std::vector<Index> leaving(offsets.back()), at(offsets.begin(), offsets.end() - 1);
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index from = t[c], to = t[next(c)];
      for (Index e = offsets[from]; e < at[from]; ++e) {
        if (leaving[e] == to) return true;
      }
      leaving[at[from]++] = to;
    }
  }
  return false;
}

// Makes neighbours agree in rings around the first triangle, as far as possible: where the rings meet on a
// one-sided surface, neighbours disagree.
void orient_in_rings(std::vector<Triangle>& triangles) {
  struct Side {
    Index low, high, triangle;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles[t][c], triangles[t][next(c)]);
      sides.push_back({low, high, t});
    }
  }
  std::ranges::sort(sides);
  const auto runs = [&](Index t, Index from, Index to) {
    const Triangle& v = triangles[t];
    return (v[0] == from && v[1] == to) || (v[1] == from && v[2] == to) || (v[2] == from && v[0] == to);
  };
  std::vector<char> reached(triangles.size(), 0);
  std::vector<Index> ring{0};
  reached[0] = 1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Triangle v = triangles[ring[i]];
    for (int c = 0; c < 3; ++c) {
      const Index from = v[c], to = v[next(c)];
      const auto [low, high] = std::minmax(from, to);
      auto side = std::ranges::lower_bound(sides, Side{low, high, none});
      for (; side != sides.end() && side->low == low && side->high == high; ++side) {
        if (std::exchange(reached[side->triangle], 1)) continue;
        if (runs(side->triangle, from, to))
          std::swap(triangles[side->triangle][1], triangles[side->triangle][2]);
        ring.push_back(side->triangle);
      }
    }
  }
}

}  // namespace

OpenMesh open_surface(Points points, const std::vector<Triangle>& triangles) {
  OpenMesh open;
  std::vector<Triangle> turned = triangles;
  bool two_sided = !runs_twice(turned, points.size());
  if (!two_sided) {
    orient_in_rings(turned);
    two_sided = !runs_twice(turned, points.size());
  }
  // Neighbours that disagree are not joined: there a one-sided surface is cut.
  open.mesh = triangulation_of(turned, static_cast<Index>(points.size()));
  for (Index t = 0; t < open.mesh.size(); ++t) open.triangle.push_back(t);
  if (two_sided) {
    open.points.assign(points.begin(), points.end());
    for (Index v = 0; v < open.vertices(); ++v) open.vertex.push_back(v);
    return finished(std::move(open));
  }
  Joins joins;
  for (Index t = 0; t < open.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = open.mesh.adjacent[t][c];
      if (other == none || other < t) continue;
      const int back = open.mesh.corner_across(other, t);
      joins.emplace_back(3 * t + next(c), 3 * other + previous(back));
      joins.emplace_back(3 * t + previous(c), 3 * other + next(back));
    }
  }
  Split split = split_vertices(turned.size(), joins);
  for (const Index corner : split.first_corner) {
    open.vertex.push_back(turned[corner / 3][corner % 3]);
    open.points.push_back(points[open.vertex.back()]);
  }
  open.mesh = triangulation_of(std::move(split.triangles), open.vertices());
  return finished(std::move(open));
}

namespace {

// The connected part of each triangle, numbered by first triangles.
std::vector<Index> parts_of(const OpenMesh& whole, const std::vector<Index>& label, const Cuts& cuts) {
  Triangulation cut = whole.mesh;
  for (Index t = 0; t < cut.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = whole.mesh.adjacent[t][c];
      if (other == none) continue;
      if (label[other] != label[t] || cuts[t][c] || cuts[other][whole.mesh.corner_across(other, t)])
        cut.adjacent[t][c] = none;
    }
  }
  return find_components(cut).of_triangle;
}

OpenMesh open_part(const OpenMesh& whole, const std::vector<Index>& members, const std::vector<Index>& part,
                   const Cuts& cuts, std::vector<Index>& local) {
  const Triangulation& mesh = whole.mesh;
  for (std::size_t i = 0; i < members.size(); ++i) local[members[i]] = static_cast<Index>(i);
  Joins joins;
  for (const Index t : members) {
    for (int c = 0; c < 3; ++c) {
      const Index other = mesh.adjacent[t][c];
      if (other == none || other < t || part[other] != part[t]) continue;
      const int back = mesh.corner_across(other, t);
      if (cuts[t][c] || cuts[other][back]) continue;
      joins.emplace_back(3 * local[t] + next(c), 3 * local[other] + previous(back));
      joins.emplace_back(3 * local[t] + previous(c), 3 * local[other] + next(back));
    }
  }
  Split split = split_vertices(members.size(), joins);
  OpenMesh open;
  for (const Index corner : split.first_corner) {
    const Index v = mesh.triangles[members[corner / 3]][corner % 3];
    open.points.push_back(whole.points[v]);
    open.vertex.push_back(whole.vertex[v]);
  }
  for (const Index t : members) open.triangle.push_back(whole.triangle[t]);
  open.mesh = triangulation_of(std::move(split.triangles), open.vertices());
  return finished(std::move(open));
}

}  // namespace

std::vector<OpenMesh> open_parts(const OpenMesh& whole, const std::vector<Index>& label, const Cuts& cuts) {
  const std::vector<Index> part = parts_of(whole, label, cuts);
  std::vector<std::vector<Index>> members;
  for (Index t = 0; t < whole.mesh.size(); ++t) {
    if (static_cast<std::size_t>(part[t]) == members.size()) members.emplace_back();
    members[part[t]].push_back(t);
  }
  std::vector<Index> local;
  local.assign(whole.mesh.triangles.size(), none);
  std::vector<OpenMesh> parts;
  for (const std::vector<Index>& own : members) parts.push_back(open_part(whole, own, part, cuts, local));
  return parts;
}

std::vector<OpenMesh> open_parts(const OpenMesh& whole, const std::vector<Index>& label) {
  return open_parts(whole, label, Cuts(whole.mesh.triangles.size(), {0, 0, 0}));
}

OpenMesh open_selection(const OpenMesh& whole, const std::vector<Index>& triangles) {
  const std::size_t count = whole.mesh.triangles.size();
  std::vector<Index> part(count, none), local(count, none);
  for (const Index t : triangles) part[t] = 0;
  const Cuts no_cuts(count, {0, 0, 0});
  return open_part(whole, triangles, part, no_cuts, local);
}

}  // namespace rimline
