// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/embed.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/vec.h"
#include "map/graph.h"
#include "map/mesh_system.h"

namespace rimline {
namespace {

// Raises the evenness of all points within `rings` edges of the triangles given.
std::size_t raise_evenness(const Triangulation& mesh, const std::vector<Index>& triangles, int rings,
                           double step, std::vector<double>& evenness) {
  std::vector<char> marked(evenness.size(), 0);
  for (const Index t : triangles) {
    for (const Index v : mesh.triangles[t]) marked[v] = 1;
  }
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = marked;
    for (const Triangle& t : mesh.triangles) {
      if (before[t[0]] || before[t[1]] || before[t[2]]) marked[t[0]] = marked[t[1]] = marked[t[2]] = 1;
    }
  }
  std::size_t touched = 0;
  for (std::size_t v = 0; v < evenness.size(); ++v) {
    if (marked[v]) evenness[v] = std::min(1.0, evenness[v] + step);
    touched += evenness[v] > 0;
  }
  return touched;
}

}  // namespace

bool has_height(const std::vector<UV>& uv, const Triangle& t, double least) {
  const UV e = uv[t[1]] - uv[t[0]], f = uv[t[2]] - uv[t[0]], g = f - e;
  const double square = std::max({e.u * e.u + e.v * e.v, f.u * f.u + f.v * f.v, g.u * g.u + g.v * g.v});
  return e.u * f.v - e.v * f.u > least * square;
}

std::vector<Index> flipped_triangles(const std::vector<Triangle>& triangles, const std::vector<UV>& uv,
                                     const Run& run, double least) {
  std::vector<char> flipped(triangles.size());
  parallel_for_each(triangles.size(), Stage::Refine, run, [&](Index t) {
    flipped[t] = least > 0 ? !has_height(uv, triangles[t], least) : !(twice_area(uv, triangles[t]) > 0);
  });
  std::vector<Index> found;
  for (std::size_t t = 0; t < flipped.size(); ++t) {
    if (flipped[t]) found.push_back(static_cast<Index>(t));
  }
  return found;
}

Embedding embed(Points points, const Triangulation& mesh, const std::vector<Loop>& loops, double residual,
                int repairs, std::vector<UV>& uv, const Run& run, double least) {
  constexpr double exact = 1e-14;  // near the limit of double precision, which crowded regions need
  const Index n = static_cast<Index>(points.size());
  std::vector<char> fixed(uv.size(), 0);
  for (const Index i : loops.front().points) fixed[i] = 1;
  std::vector<double> evenness;
  Embedding embedding;
  for (int attempt = 0;; ++attempt) {
    embedding.map = solve_system(mesh_system(points, mesh, loops, evenness, fixed, uv, run),
                                 attempt == 0 ? residual : std::min(residual, exact), uv, run);
    if (embedding.map.residual > residual) {
      throw Error(ErrorCode::NoConvergence,
                  "the map's linear system was not solved to the residual asked for");
    }
    const std::vector<Index> flipped = flipped_triangles(mesh.triangles, uv, run, least);
    embedding.flips = flipped.size();
    if (flipped.empty() || attempt == repairs) return embedding;
    if (attempt == 0) {
      evenness.assign(n, 0);  // solves again, exactly
    } else {
      embedding.evened = raise_evenness(mesh, flipped, attempt, attempt < repairs - 1 ? 0.5 : 1, evenness);
    }
    if (attempt == repairs - 1) std::fill(evenness.begin(), evenness.end(), 1);
  }
}

}  // namespace rimline
