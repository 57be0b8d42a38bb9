// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/domain_traits.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "fill/fill_holes.h"
#include "map/conformal_descent.h"
#include "map/domain.h"
#include "map/embed.h"
#include "map/free_map.h"
#include "map/outline_crossings.h"
#include "map/weights.h"
#include "mesh/constrained_delaunay.h"
#include "mesh/flip.h"
#include "mesh/insert.h"
#include "mesh/quality.h"
#include "patch/pinches.h"
#include "patch/refine_patch.h"
#include "patch/repair.h"
#include "patch/topology.h"
#include "rimline/refine_surface.h"

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

// How deep inside a convex polygon a point lies: the distance to the nearest side's line.
double depth_inside(UV point, const std::vector<Index>& polygon, const std::vector<UV>& uv) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const UV a = uv[polygon[i]], b = uv[polygon[next_in(i, polygon.size())]];
    const double area = (b.u - a.u) * (point.v - a.v) - (b.v - a.v) * (point.u - a.u);
    depth = std::min(depth, area / distance(a, b));
  }
  return depth;
}

// Puts the rims of holes on small circles that can not meet, each about the centre that `uv` gives it and
// turned as its first point lies.
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

// The spacing of every point, copies included.
std::vector<double> spacing_with(Points points, const Neighbours& neighbours,
                                 const std::vector<Index>& copies) {
  std::vector<double> spacing = local_spacing(points, neighbours);
  for (const Index v : copies) spacing.push_back(spacing[v]);
  return spacing;
}

class Refiner {
 public:
  // `points` may end in copies of points where loops touch; `neighbours` and `stars` know the others only.
  Refiner(Points points, const Neighbours& neighbours, const Stars* stars, const Separated& outline,
          std::vector<Triangle> survey, const RefineOptions& options, const Run& run)
      : points_(points),
        neighbours_(neighbours),
        known_stars_(stars),
        survey_(std::move(survey)),
        loops_(outline.loops),
        point_count_(points.size()),
        copies_(outline.original),
        options_(options),
        run_(run),
        spacing_(spacing_with(points, neighbours, outline.original)),
        uv_(points.size() + outline.loops.size() - 1) {
    place_on_circle(points, loops_.front().points, {0, 0}, 1, 0, 1, uv_);
  }

  Patch refine() {
    // Bad edges in so small a share do not pay for one more round.
    const std::size_t tolerated = 18 * points_.size() / 10000;  // 0.06 % of the edges
    Patch patch;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options_.rounds; ++round) {
      run_.progress(Stage::Refine, round, options_.rounds);
      Triangulation mesh;
      bool surveyed = false;
      if (round == 0) {
        surveyed = take_survey(mesh);
        if (!surveyed) mesh = triangulate_first();
      } else if (!try_triangulate(mesh)) {
        break;  // the rough map before has rims that cross
      }
      const std::size_t flips = flip_edges(points_, mesh, copies_, run_);
      const EdgeQuality quality = edge_quality(points_, mesh, spacing_, run_);
      patch.rounds.push_back({flips, quality.bad, quality.length});
      if (round == 0 && !surveyed && quality.bad >= doubtful) check_topology();
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
    if (options_.holes.fill) close_holes(patch);
    map_to_domain(patch);
    patch.uv.assign(uv_.begin(), uv_.begin() + static_cast<std::ptrdiff_t>(points_.size()));
    patch.triangles = std::move(mesh_.triangles);
    return patch;
  }

 private:
  static constexpr double rough = 1e-6;  // residual of the maps that only lead to the next mesh
  // A disc drawn over a handle or a one-sided strip has at least one bad edge for each point around it.
  static constexpr std::size_t doubtful = 8;

  // From here on the patch has the fills' vertices, after the points, and the loops that stay.
  void close_holes(Patch& patch) {
    HoleFills filled = fill_holes(points_, mesh_, loops_, copies_, spacing_, options_, run_);
    all_points_.assign(points_.begin(), points_.end());
    all_points_.insert(all_points_.end(), filled.added.begin(), filled.added.end());
    points_ = all_points_;
    loops_ = std::move(filled.loops);
    uv_.resize(point_count_);  // what follows is mapped anew
    uv_.resize(points_.size() + loops_.size() - 1);
    std::vector<Triangle> triangles = std::move(mesh_.triangles);
    triangles.insert(triangles.end(), filled.triangles.begin(), filled.triangles.end());
    mesh_ = triangulation_of(std::move(triangles), static_cast<Index>(points_.size()));
    patch.added = std::move(filled.added);
    patch.fills = std::move(filled.fills);
  }

  // The last map, on the last mesh.
  void map_to_domain(Patch& patch) {
    const std::vector<Index>& outer = loops_.front().points;
    if (traits(options_.domain).released) {
      if (map_freely(patch)) return;
    } else if (traits(options_.domain).outline == Outline::Box) {
      place_outline(points_, outer, options_.domain, options_.corners, uv_);
    }
    map_to_outline(patch);
    if (traits(options_.domain).released) release(patch);
  }

  // The outline as uv_ has it.
  void map_to_outline(Patch& patch) {
    constexpr int repairs = 8;
    const Embedding embedding = embed(points_, mesh_, loops_, options_.residual, repairs, uv_, run_);
    patch.domain = traits(options_.domain).released ? Domain::Disc : options_.domain;
    patch.map = embedding.map;
    patch.uv_flips = embedding.flips;
    patch.evened = embedding.evened;
  }

  // Least squares, which may turn triangles over where the mesh folds, or leave them all but flat in uv, and
  // may cross the outline. False, and uv_ as it was, where it does.
  bool map_freely(Patch& patch) {
    constexpr double flat = 1.05, little = 1e-3;
    for (const double least : {0.0, little}) {  // then no inner edge without a weight
      std::vector<UV> uv;
      const MapSummary map = free_map(points_, mesh_, loops_.front().points, least, uv, run_);
      if (!flipped_triangles(mesh_.triangles, uv, run_).empty()) continue;
      if (!crossing_points(loops_, uv).empty() || conformal_distortion(points_, mesh_, uv) > flat)
        return false;
      patch.map = map;
      patch.uv_flips = 0;
      take_free(std::move(uv), patch);
      return true;
    }
    return false;
  }

  // From the disc's map, which has no flips and no crossings, by steps that make none.
  void release(Patch& patch) {
    std::vector<UV> uv(uv_.begin(), uv_.begin() + static_cast<std::ptrdiff_t>(points_.size()));
    if (patch.uv_flips == 0 && relax_conformally(points_, mesh_, loops_, uv, run_) > 0) {
      take_free(std::move(uv), patch);
    } else {
      scale_to_area(points_, mesh_, uv_);
    }
  }

  void take_free(std::vector<UV> uv, Patch& patch) {
    patch.domain = Domain::Free;
    lay_level(points_, loops_.front().points, uv);
    scale_to_area(points_, mesh_, uv);
    uv.resize(uv_.size());
    uv_ = std::move(uv);
  }

  const Stars& stars() {
    if (known_stars_ == nullptr) {
      own_stars_ = find_stars(points_.first(neighbours_.size()), neighbours_, {}, {}, run_);
      known_stars_ = &own_stars_;
    }
    return *known_stars_;
  }

  void check_topology() {
    constexpr double enough = 0.5;  // of the points, for the verdict to count
    const Topology topology = find_topology(points_, stars());
    if (topology.coverage < enough) return;
    if (!topology.orientable) throw Error(ErrorCode::NotADisc, "the surface is one-sided (not orientable)");
    if (topology.genus > 0) {
      throw Error(ErrorCode::NotADisc, "the surface is no disc: it has " + std::to_string(topology.genus) +
                                           (topology.genus == 1 ? " handle" : " handles"));
    }
  }

  // Where loops touch, the survey does not know the copies of the point.
  bool take_survey(Triangulation& mesh) {
    if (!copies_.empty()) return false;
    std::optional<Triangulation> found = mesh_of_survey(points_, neighbours_, loops_, std::move(survey_));
    if (found) mesh = std::move(*found);
    return found.has_value();
  }

  // The first map knows neighbours only, and rims may cross in it: then once more, the rims held apart.
  Triangulation triangulate_first() {
    const Index nodes = static_cast<Index>(uv_.size());
    std::vector<char> fixed(nodes, 0);
    for (const Index i : loops_.front().points) fixed[i] = 1;
    const Graph graph = neighbour_graph(fixed);
    solve_map(graph, fixed, rough, uv_, run_);
    Triangulation mesh;
    if (try_triangulate(mesh)) return mesh;
    hold_rims_apart(points_, loops_, uv_);
    for (std::size_t h = 1; h < loops_.size(); ++h) {
      for (const Index i : loops_[h].points) fixed[i] = 1;
    }
    solve_map(graph, fixed, rough, uv_, run_);
    return triangulate();
  }

  // eq. (4) with the local Voronoi cells as neighbourhoods.
  Graph neighbour_graph(const std::vector<char>& fixed) {
    const Index nodes = static_cast<Index>(fixed.size());
    std::vector<WeightedEdge> edges = star_edges(stars());
    if (!copies_.empty()) share_with_copies(points_, loops_, copies_, edges);
    add_wheels(loops_, static_cast<Index>(points_.size()), edges);
    Graph graph = make_graph(nodes, edges);
    if (unreachable(graph, fixed).empty()) return graph;
    join_islands(neighbours_, fixed, edges);
    return make_graph(nodes, edges);
  }

  // False where rims cross in uv.
  bool try_triangulate(Triangulation& mesh) {
    try {
      mesh = triangulate();
      return true;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::NotADisc) throw;
      return false;
    }
  }

  Triangulation triangulate() {
    std::vector<Triangle> triangles = constrained_delaunay(std::span(uv_).first(points_.size()), loops_);
    Triangulation mesh = triangulation_of(std::move(triangles), static_cast<Index>(points_.size()));
    const std::vector<Index> missing = insert_missing(points_, neighbours_, mesh);
    if (!missing.empty())
      throw Error(ErrorCode::UnreachableInterior, "points lie apart from the mesh", missing);
    return mesh;
  }

  Points points_;
  const Neighbours& neighbours_;
  const Stars* known_stars_;
  Stars own_stars_;  // where none were given and some were needed
  std::vector<Triangle> survey_;
  std::vector<Loop> loops_;
  std::size_t point_count_;        // copies included, vertices of fills not
  std::vector<Point> all_points_;  // what points_ shows once holes are filled
  const std::vector<Index>& copies_;
  const RefineOptions& options_;
  const Run& run_;
  std::vector<double> spacing_;
  std::vector<UV> uv_;  // points, then the centres of the holes
  Triangulation mesh_;  // the best so far
};

// All that runs in parallel below keeps to the threads of the run.
Patch refine_in_arena(Points points, const Neighbours& neighbours, const Stars* stars,
                      const Separated& outline, std::vector<Triangle> survey, const RefineOptions& options,
                      const Run& run) {
  tbb::task_arena arena(thread_count(run));
  return arena.execute(
      [&] { return Refiner(points, neighbours, stars, outline, std::move(survey), options, run).refine(); });
}

}  // namespace

Patch refine_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   const RefineOptions& options, const Run& run) {
  const Separated outline = separate_pinches(loops, static_cast<Index>(points.size()));
  return refine_patch(points, neighbours, nullptr, outline, {}, options, run);
}

Patch refine_patch(Points points, const Neighbours& neighbours, const Stars* stars, const Separated& outline,
                   std::vector<Triangle> survey, const RefineOptions& options, const Run& run) {
  if (outline.original.empty())
    return refine_in_arena(points, neighbours, stars, outline, std::move(survey), options, run);
  const Index n = static_cast<Index>(points.size());
  std::vector<Point> with_copies(points.begin(), points.end());
  for (const Index v : outline.original) with_copies.push_back(points[v]);
  Patch patch = refine_in_arena(with_copies, neighbours, stars, outline, {}, options, run);
  const auto copies = static_cast<Index>(outline.original.size());
  const auto without_copies = [&](Index v) {
    return v < n ? v : v < n + copies ? outline.original[v - n] : v - copies;
  };
  for (Triangle& t : patch.triangles) {
    for (Index& v : t) v = without_copies(v);
  }
  for (HoleFill& fill : patch.fills) {
    for (Index& v : fill.rim) v = without_copies(v);
  }
  patch.uv.erase(patch.uv.begin() + n, patch.uv.begin() + n + copies);
  return patch;
}

}  // namespace rimline
