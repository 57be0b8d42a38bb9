// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/first_mesh.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/vec.h"
#include "map/weights.h"
#include "mesh/constrained_delaunay.h"
#include "mesh/insert.h"

namespace rimline {
namespace {

// A loop on a circle, by chord length (section 5): counter-clockwise from `start` for turn = 1, clockwise for
// turn = -1.
void place_on_circle(Points points, const std::vector<Index>& loop, UV centre, double radius, double start,
                     double turn, std::vector<UV>& uv) {
  const std::size_t n = loop.size();
  std::vector<double> along(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
    along[i + 1] = along[i] + distance(points[loop[i]], points[loop[(i + 1) % n]]);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = start + turn * 2 * std::numbers::pi * along[i] / along[n];
    uv[loop[i]] = {centre.u + radius * std::cos(angle), centre.v + radius * std::sin(angle)};
  }
}

double distance(UV a, UV b) { return std::hypot(a.u - b.u, a.v - b.v); }

// The depth of a point inside a convex polygon: the distance to the nearest side's line.
double depth_inside(UV point, const std::vector<Index>& polygon, const std::vector<UV>& uv) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const UV a = uv[polygon[i]], b = uv[polygon[i + 1 < polygon.size() ? i + 1 : 0]];
    depth = std::min(depth, twice_area(a, b, point) / distance(a, b));
  }
  return depth;
}

// Places the rims of holes on small disjoint circles, each about the centre that `uv` gives it, rotated to
// the position of its first point.
void hold_rims_apart(Points points, const std::vector<Loop>& loops, std::vector<UV>& uv) {
  const std::vector<UV> centres(uv.begin() + static_cast<std::ptrdiff_t>(points.size()), uv.end());
  for (std::size_t h = 0; h < centres.size(); ++h) {
    const UV centre = centres[h];
    double room = depth_inside(centre, loops.front().points, uv) / 2;
    for (std::size_t g = 0; g < centres.size(); ++g) {
      if (g != h) room = std::min(room, distance(centre, centres[g]) / 2);
    }
    const std::vector<Index>& rim = loops[h + 1].points;
    double size = 0;
    for (const Index i : rim) size += distance(uv[i], centre) / static_cast<double>(rim.size());
    const UV first = uv[rim.front()];
    const double start = std::atan2(first.v - centre.v, first.u - centre.u);
    place_on_circle(points, rim, centre, std::min(size, 0.9 * room), start, -1, uv);
  }
}

// eq. (4) with the local Voronoi cells as neighbourhoods.
Graph neighbour_graph(const Neighbours& neighbours, const Stars& stars, const std::vector<Loop>& loops,
                      const std::vector<char>& fixed) {
  const auto nodes = static_cast<Index>(fixed.size());
  std::vector<WeightedEdge> edges = star_edges(stars);
  add_wheels(loops, neighbours.size(), edges);
  Graph graph = make_graph(nodes, edges);
  if (unreachable(graph, fixed).empty()) return graph;
  join_islands(neighbours, fixed, edges);
  return make_graph(nodes, edges);
}

// None where rims cross in uv.
std::optional<Triangulation> try_in_plane(Points points, const Neighbours& neighbours,
                                          const std::vector<Loop>& loops, const std::vector<UV>& uv) {
  try {
    return mesh_in_plane(points, neighbours, loops, uv);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::NotADisc) throw;
    return {};
  }
}

}  // namespace

std::vector<UV> outline_on_circle(Points points, const std::vector<Loop>& loops) {
  std::vector<UV> uv(points.size() + loops.size() - 1);
  place_on_circle(points, loops.front().points, {0, 0}, 1, 0, 1, uv);
  return uv;
}

Triangulation mesh_in_plane(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                            const std::vector<UV>& uv) {
  std::vector<Triangle> triangles = constrained_delaunay(std::span(uv).first(points.size()), loops);
  Triangulation mesh = triangulation_of(std::move(triangles), static_cast<Index>(points.size()));
  const std::vector<Index> missing = insert_missing(points, neighbours, mesh);
  if (!missing.empty())
    throw Error(ErrorCode::UnreachableInterior, "points lie apart from the mesh", missing);
  return mesh;
}

Triangulation first_mesh(Points points, const Neighbours& neighbours, const Stars& stars,
                         const std::vector<Loop>& loops, std::vector<UV>& uv, const Run& run) {
  constexpr double rough = 1e-6;  // residual
  std::vector<char> fixed(uv.size(), 0);
  for (const Index i : loops.front().points) fixed[i] = 1;
  const Graph graph = neighbour_graph(neighbours, stars, loops, fixed);
  solve_map(graph, fixed, rough, uv, run);
  // The map depends on neighbours only, so that rims may cross in it. Then it is made again with the rims
  // held apart.
  if (auto mesh = try_in_plane(points, neighbours, loops, uv)) return std::move(*mesh);
  hold_rims_apart(points, loops, uv);
  for (std::size_t h = 1; h < loops.size(); ++h) {
    for (const Index i : loops[h].points) fixed[i] = 1;
  }
  solve_map(graph, fixed, rough, uv, run);
  return mesh_in_plane(points, neighbours, loops, uv);
}

}  // namespace rimline
