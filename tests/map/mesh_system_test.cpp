// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/mesh_system.h"

#include <doctest/doctest.h>

#include <cstring>

#include "base/random.h"
#include "map/weights.h"
#include "rimline/refine_surface.h"
#include "rimline/sample.h"

namespace rimline {
namespace {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void check_same(const MapSystem& a, const MapSystem& b) {
  CHECK(same_bytes(a.matrix.diagonal, b.matrix.diagonal));
  CHECK(same_bytes(a.matrix.offsets, b.matrix.offsets));
  CHECK(same_bytes(a.matrix.columns, b.matrix.columns));
  CHECK(same_bytes(a.matrix.values, b.matrix.values));
  CHECK(same_bytes(a.right, b.right));
  CHECK(same_bytes(a.unknown, b.unknown));
}

// Edge by edge, by way of a graph.
MapSystem system_by_graph(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                          std::span<const double> evenness, const std::vector<char>& fixed,
                          const std::vector<UV>& uv) {
  std::vector<WeightedEdge> edges;
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (mesh.adjacent[t][c] > t) continue;
      const Triangle& v = mesh.triangles[t];
      edges.push_back({v[next(c)], v[previous(c)], cotangent_weight(points, mesh, t, c, evenness)});
    }
  }
  add_wheels(loops, static_cast<Index>(points.size()), edges);
  return graph_system(make_graph(static_cast<Index>(uv.size()), edges), fixed, uv);
}

}  // namespace

TEST_CASE("the system of a mesh with holes is that of its graph to the last bit, for any number of threads") {
  const Sample s = sample({Shape::SquareWithHoles, Sampling::Random, 3000, 0}, {});
  const Patch patch = refine_patch(s.points, find_neighbours(s.points, 20, {}), s.loops, {}, {});
  const Triangulation mesh = triangulation_of(patch.triangles, static_cast<Index>(s.points.size()));
  REQUIRE(s.loops.size() > 1);
  std::vector<UV> uv = patch.uv;
  uv.resize(s.points.size() + s.loops.size() - 1);
  std::vector<char> fixed(uv.size(), 0);
  for (const Index v : s.loops[0].points) fixed[v] = 1;
  std::vector<double> evenness(s.points.size());
  Random random(3);
  for (double& e : evenness) e = random.uniform();
  for (const int threads : {1, 2}) {
    Run run;
    run.threads = threads;
    check_same(mesh_system(s.points, mesh, s.loops, {}, fixed, uv, run),
               system_by_graph(s.points, mesh, s.loops, {}, fixed, uv));
    check_same(mesh_system(s.points, mesh, s.loops, evenness, fixed, uv, run),
               system_by_graph(s.points, mesh, s.loops, evenness, fixed, uv));
  }
}

}  // namespace rimline
