// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/refine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <utility>

#include "map/embed.h"
#include "map/weights.h"
#include "mesh/constrained_delaunay.h"
#include "mesh/flip.h"
#include "mesh/insert.h"
#include "mesh/quality.h"

namespace rimline {
namespace {
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double env(const char* n, double d) {
  const char* s = getenv(n);
  return s ? atof(s) : d;
}
void say(const char* what) {
  static double last = now();
  static clock_t lc = clock();
  double t = now();
  clock_t c = clock();
  if (getenv("RL_T"))
    fprintf(stderr, "  %-12s wall %.3f cpu %.3f\n", what, t - last, double(c - lc) / CLOCKS_PER_SEC);
  last = now();
  lc = clock();
}

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

class Refiner {
 public:
  Refiner(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
          const RefineOptions& options, const Run& run)
      : points_(points),
        neighbours_(neighbours),
        loops_(loops),
        options_(options),
        run_(run),
        spacing_(local_spacing(neighbours)),
        uv_(points.size() + loops.size() - 1) {
    place_on_circle(points, loops.front().points, uv_);
  }

  Patch refine() {
    // Bad edges in so small a share do not pay for one more round.
    const std::size_t tolerated = 3 * points_.size() / 10000;
    say("start");
    map_neighbours(env("RL_STIFF", 1));
    Patch patch;
    Triangulation best;
    double least = 0;
    for (int round = 0; round < options_.rounds; ++round) {
      run_.progress(Stage::Refine, round, options_.rounds);
      Triangulation mesh = triangulate();
      say("triangulate");
      RefineRound summary{flip_edges(points_, mesh, run_), 0, 0};
      const EdgeQuality quality = edge_quality(points_, mesh, spacing_);
      say("flip");
      summary.bad_edges = quality.bad;
      summary.length = quality.length;
      patch.rounds.push_back(summary);
      if (getenv("RL_T"))
        fprintf(stderr, "   round %d flips %zu bad %zu length %.9g\n", round, summary.flips,
                summary.bad_edges, summary.length);
      // A better mesh has the shorter edges; a thousandth of a percent is no progress.
      const bool better = round == 0 || quality.length < least * (1 - 1e-5);
      if (better) {
        least = quality.length;
        best = std::move(mesh);
      }
      const bool last = !better || quality.bad <= tolerated || round + 1 == options_.rounds;
      embed_mesh(best, last, patch);
      say("embed");
      if (last) break;
    }
    patch.uv.assign(uv_.begin(), uv_.begin() + static_cast<std::ptrdiff_t>(points_.size()));
    patch.triangles = std::move(best.triangles);
    return patch;
  }

 private:
  const double rough = env("RL_ROUGH", 1e-6);  // residual of the maps that only lead to the next mesh

  // The first map: neighbours in the local Voronoi cells.
  void map_neighbours(double stiffness) {
    const Stars stars = find_stars(points_, neighbours_, {}, {}, run_);
    say("stars");
    std::vector<char> fixed(uv_.size(), 0);
    for (const Index i : loops_.front().points) fixed[i] = 1;
    std::vector<WeightedEdge> edges = star_edges(stars);
    add_wheels(loops_, static_cast<Index>(points_.size()), stiffness, edges);
    Graph g = make_graph(static_cast<Index>(uv_.size()), edges);
    if (!unreachable(g, fixed).empty()) {
      join_islands(neighbours_, fixed, edges);
      g = make_graph(static_cast<Index>(uv_.size()), edges);
    }
    say("graph");
    auto r = solve_map(g, fixed, rough, uv_, run_);
    say("solve");
    if (getenv("RL_T")) fprintf(stderr, "   it %d res %g\n", r.iterations, r.residual);
  }

  Triangulation triangulate() {
    std::vector<Triangle> triangles = constrained_delaunay(std::span(uv_).first(points_.size()), loops_);
    say("delaunay");
    Triangulation mesh = triangulation_of(std::move(triangles), static_cast<Index>(points_.size()));
    const std::vector<Index> missing = insert_missing(points_, neighbours_, mesh);
    if (!missing.empty()) throw Error(ErrorCode::NotADisc, "points far from the mesh", missing);
    return mesh;
  }

  void embed_mesh(const Triangulation& mesh, bool last, Patch& patch) {
    const Embedding embedding =
        embed(points_, mesh, loops_, last ? options_.residual : rough, last ? 8 : 0, uv_, run_);
    patch.map = embedding.map;
    patch.uv_flips = embedding.flips;
    patch.evened = embedding.evened;
    if (getenv("RL_T"))
      fprintf(stderr, "   embed it %d res %g flips %zu evened %zu\n", embedding.map.iterations,
              embedding.map.residual, embedding.flips, embedding.evened);
  }

  Points points_;
  const Neighbours& neighbours_;
  const std::vector<Loop>& loops_;
  const RefineOptions& options_;
  const Run& run_;
  std::vector<double> spacing_;
  std::vector<UV> uv_;  // points, then the centres of the holes
};

}  // namespace

Patch refine_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   const RefineOptions& options, const Run& run) {
  return Refiner(points, neighbours, loops, options, run).refine();
}

}  // namespace rimline
