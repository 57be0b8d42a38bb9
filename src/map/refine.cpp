// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/refine.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "map/embed.h"
#include "map/pinches.h"
#include "map/refine_patch.h"
#include "map/topology.h"
#include "map/weights.h"
#include "mesh/constrained_delaunay.h"
#include "mesh/flip.h"
#include "mesh/insert.h"
#include "mesh/quality.h"

namespace rimline {
namespace {

// The loop on the unit circle, by chord length (section 5), counter-clockwise.
void place_on_circle(Points points, const std::vector<Index>& loop, std::vector<UV>& uv) {
  const std::size_t n = loop.size();
  std::vector<double> along(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
    along[i + 1] = along[i] + distance(points[loop[i]], points[loop[(i + 1) % n]]);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * along[i] / along[n];
    uv[loop[i]] = {std::cos(angle), std::sin(angle)};
  }
}

// The spacing of every point, copies included.
std::vector<double> spacing_with(const Neighbours& neighbours, const std::vector<Index>& copies) {
  std::vector<double> spacing = local_spacing(neighbours);
  for (const Index v : copies) spacing.push_back(spacing[v]);
  return spacing;
}

class Refiner {
 public:
  // `points` may end in copies of points where loops touch; `neighbours` and `stars` know the others only.
  Refiner(Points points, const Neighbours& neighbours, const Stars& stars, const Separated& outline,
          const RefineOptions& options, const Run& run)
      : points_(points),
        neighbours_(neighbours),
        stars_(stars),
        loops_(outline.loops),
        copies_(outline.original),
        options_(options),
        run_(run),
        spacing_(spacing_with(neighbours, outline.original)),
        uv_(points.size() + outline.loops.size() - 1) {
    place_on_circle(points, loops_.front().points, uv_);
  }

  Patch refine() {
    // Bad edges in so small a share do not pay for one more round.
    const std::size_t tolerated = 3 * points_.size() / 10000;
    Patch patch;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options_.rounds; ++round) {
      run_.progress(Stage::Refine, round, options_.rounds);
      Triangulation mesh = round == 0 ? triangulate_first() : triangulate();
      const std::size_t flips = flip_edges(points_, mesh, copies_, run_);
      const EdgeQuality quality = edge_quality(points_, mesh, spacing_);
      patch.rounds.push_back({flips, quality.bad, quality.length});
      if (round == 0 && quality.bad >= doubtful) check_topology();
      // Of two meshes over the same points the one of shorter edges is better; less is no progress.
      constexpr double progress = 1e-5;
      const bool better = quality.length < least * (1 - progress);
      if (better) {
        least = quality.length;
        mesh_ = std::move(mesh);
      }
      if (!better || quality.bad <= tolerated || round + 1 == options_.rounds) break;
      embed(points_, mesh_, loops_, rough, 0, uv_, run_);
    }
    constexpr int repairs = 8;
    const Embedding embedding = embed(points_, mesh_, loops_, options_.residual, repairs, uv_, run_);
    patch.map = embedding.map;
    patch.uv_flips = embedding.flips;
    patch.evened = embedding.evened;
    patch.uv.assign(uv_.begin(), uv_.begin() + static_cast<std::ptrdiff_t>(points_.size()));
    patch.triangles = std::move(mesh_.triangles);
    return patch;
  }

 private:
  static constexpr double rough = 1e-6;  // residual of the maps that only lead to the next mesh
  // A disc drawn over a handle or a one-sided strip has at least one bad edge for each point around it.
  static constexpr std::size_t doubtful = 8;

  void check_topology() const {
    constexpr double enough = 0.5;  // of the points, for the verdict to count
    const Topology topology = find_topology(stars_);
    if (topology.coverage < enough) return;
    if (!topology.orientable) throw Error(ErrorCode::NotADisc, "the surface is one-sided (not orientable)");
    if (topology.genus > 0) {
      throw Error(ErrorCode::NotADisc, "the surface is no disc: it has " + std::to_string(topology.genus) +
                                           (topology.genus == 1 ? " handle" : " handles"));
    }
  }

  // The first map knows neighbours only, and rims may cross in it: then once more, the rims stiffer.
  Triangulation triangulate_first() {
    for (const double stiffness : {1.0, 10.0, 100.0}) {
      map_neighbours(stiffness);
      try {
        return triangulate();
      } catch (const Error& error) {
        if (error.code() != ErrorCode::NotADisc || stiffness == 100 || loops_.size() == 1) throw;
      }
    }
    return {};
  }

  // eq. (4) with the local Voronoi cells as neighbourhoods.
  void map_neighbours(double stiffness) {
    const Index nodes = static_cast<Index>(uv_.size());
    std::vector<char> fixed(nodes, 0);
    for (const Index i : loops_.front().points) fixed[i] = 1;
    std::vector<WeightedEdge> edges = star_edges(stars_);
    if (!copies_.empty()) share_with_copies(points_, loops_, copies_, edges);
    add_wheels(loops_, static_cast<Index>(points_.size()), stiffness, edges);
    Graph graph = make_graph(nodes, edges);
    if (!unreachable(graph, fixed).empty()) {
      join_islands(neighbours_, fixed, edges);
      graph = make_graph(nodes, edges);
    }
    solve_map(graph, fixed, rough, uv_, run_);
  }

  Triangulation triangulate() {
    std::vector<Triangle> triangles = constrained_delaunay(std::span(uv_).first(points_.size()), loops_);
    Triangulation mesh = triangulation_of(std::move(triangles), static_cast<Index>(points_.size()));
    const std::vector<Index> missing = insert_missing(points_, neighbours_, mesh);
    if (!missing.empty()) throw Error(ErrorCode::NotADisc, "points lie apart from the mesh", missing);
    return mesh;
  }

  Points points_;
  const Neighbours& neighbours_;
  const Stars& stars_;
  const std::vector<Loop>& loops_;
  const std::vector<Index>& copies_;
  const RefineOptions& options_;
  const Run& run_;
  std::vector<double> spacing_;
  std::vector<UV> uv_;  // points, then the centres of the holes
  Triangulation mesh_;  // the best so far
};

}  // namespace

Patch refine_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   const RefineOptions& options, const Run& run) {
  const Separated outline = separate_pinches(loops, static_cast<Index>(points.size()));
  return refine_patch(points, neighbours, find_stars(points, neighbours, {}, {}, run), outline, options, run);
}

Patch refine_patch(Points points, const Neighbours& neighbours, const Stars& stars, const Separated& outline,
                   const RefineOptions& options, const Run& run) {
  if (outline.original.empty()) return Refiner(points, neighbours, stars, outline, options, run).refine();
  const Index n = static_cast<Index>(points.size());
  std::vector<Point> with_copies(points.begin(), points.end());
  for (const Index v : outline.original) with_copies.push_back(points[v]);
  Patch patch = Refiner(with_copies, neighbours, stars, outline, options, run).refine();
  for (Triangle& t : patch.triangles) {
    for (Index& v : t) v = v < n ? v : outline.original[v - n];
  }
  patch.uv.resize(points.size());
  return patch;
}

}  // namespace rimline
