// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "fill/fill_holes.h"
#include "map/embed.h"
#include "map/final_map.h"
#include "mesh/flip.h"
#include "mesh/orient.h"
#include "mesh/quality.h"
#include "patch/first_mesh.h"
#include "patch/refine_patch.h"
#include "patch/topology.h"
#include "rimline/refine_surface.h"

namespace rimline {
namespace {

// A disc drawn over a handle or a one-sided strip has at least one bad edge for each point around it.
void check_topology(Points points, const Stars& stars) {
  constexpr double enough = 0.5;  // share of the points below which the topology is unknown
  const Topology topology = find_topology(points, stars);
  if (topology.coverage < enough) return;
  if (!topology.orientable) throw Error(ErrorCode::NotADisc, "the surface is one-sided (not orientable)");
  if (topology.genus > 0) {
    throw Error(ErrorCode::NotADisc, "the surface is no disc: it has " + std::to_string(topology.genus) +
                                         (topology.genus == 1 ? " handle" : " handles"));
  }
}

Triangulation first_of_stars(Points points, const Neighbours& neighbours, const Stars* known,
                             const std::vector<Loop>& loops, std::vector<UV>& uv, const Run& run) {
  const Stars own = known == nullptr ? find_weighted_stars(points, neighbours, run) : Stars{};
  const Stars& stars = known == nullptr ? own : *known;
  Triangulation mesh = first_mesh(points, neighbours, stars, loops, uv, run);
  flip_edges(points, mesh, run);
  constexpr std::size_t doubtful = 8;  // bad edges
  if (edge_quality(points, mesh, local_spacing(points, neighbours), run).bad >= doubtful)
    check_topology(points, stars);
  return mesh;
}

// The mesh of least edge length, and the last map on the way to it.
struct Refined {
  Triangulation mesh;
  std::vector<UV> uv;
  std::vector<RefineRound> rounds;
};

Refined refine_rounds(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                      Triangulation mesh, std::vector<UV> uv, int most_rounds, const Run& run) {
  constexpr double rough = 1e-6;     // residual of the maps that only lead to the next mesh
  constexpr double progress = 1e-5;  // relative decrease of the length: less is no progress
  // So small a share of bad edges does not justify another round.
  const std::size_t tolerated = 18 * points.size() / 10000;  // 0.06 % of the edges
  const std::vector<double> spacing = local_spacing(points, neighbours);
  Refined best;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0;; ++round) {
    run.progress(Stage::Refine, round, most_rounds);
    const std::size_t flips = flip_edges(points, mesh, run);
    const EdgeQuality quality = edge_quality(points, mesh, spacing, run);
    best.rounds.push_back({flips, quality.bad, quality.length});
    // Of two meshes over the same points the one with less edge length is better.
    const bool better = quality.length < least * (1 - progress);
    if (better) {
      least = quality.length;
      best.mesh = std::move(mesh);
    }
    if (!better || quality.bad <= tolerated || round + 1 == most_rounds) break;
    embed(points, best.mesh, loops, rough, 0, uv, run);
    try {
      mesh = mesh_in_plane(points, neighbours, loops, uv);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::NotADisc) throw;
      break;  // rims cross in the rough map
    }
  }
  best.uv = std::move(uv);
  return best;
}

// A mesh whose holes are filled as the options say.
struct Filled {
  std::vector<Point> points;
  Triangulation mesh;
  HoleFills fills;
};

Filled fill(Points points, Triangulation mesh, const std::vector<Loop>& loops,
            const std::vector<double>& spacing, const RefineOptions& options, const Run& run) {
  Filled filled{{points.begin(), points.end()}, {}, {}};
  filled.fills = fill_holes(points, mesh, loops, spacing, options, run);
  const HoleFills& fills = filled.fills;
  filled.points.insert(filled.points.end(), fills.added.begin(), fills.added.end());
  mesh.triangles.insert(mesh.triangles.end(), fills.triangles.begin(), fills.triangles.end());
  filled.mesh = triangulation_of(std::move(mesh.triangles), static_cast<Index>(filled.points.size()));
  return filled;
}

Patch map_patch(Points points, Triangulation mesh, const std::vector<Loop>& loops, std::vector<UV> uv,
                const RefineOptions& options, const Run& run) {
  Patch patch;
  if (has_map(options.domain) && !options.map_later) {
    FinalMap map = final_map(points, mesh, loops, options, std::move(uv), run);
    patch.uv = std::move(map.uv);
    patch.domain = map.kind;
    patch.map = map.summary;
    patch.uv_flips = map.flips;
    patch.evened = map.evened;
  } else {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    patch.uv.assign(points.size(), {nan, nan});
    patch.domain = Domain::None;
  }
  patch.triangles = std::move(mesh.triangles);
  return patch;
}

Patch fill_and_map(Points points, const Neighbours& neighbours, Refined refined, std::vector<Loop> loops,
                   const RefineOptions& options, const Run& run) {
  turn_loops_along(refined.mesh.triangles, loops);  // given loops may have either direction
  if (!options.holes.fill)
    return map_patch(points, std::move(refined.mesh), loops, std::move(refined.uv), options, run);
  Filled filled =
      fill(points, std::move(refined.mesh), loops, local_spacing(points, neighbours), options, run);
  std::vector<UV>& uv = refined.uv;  // for holes and new points it is computed again
  uv.resize(points.size());
  uv.resize(filled.points.size() + filled.fills.loops.size() - (filled.fills.loops.empty() ? 0 : 1));
  Patch patch =
      map_patch(filled.points, std::move(filled.mesh), filled.fills.loops, std::move(uv), options, run);
  patch.added = std::move(filled.fills.added);
  patch.fills = std::move(filled.fills.fills);
  return patch;
}

void check_simple(const std::vector<Loop>& loops, std::size_t points) {
  std::vector<char> passed(points, 0);
  std::vector<Index> twice;
  for (const Loop& loop : loops) {
    for (const Index v : loop.points) {
      if (std::exchange(passed[v], 1)) twice.push_back(v);
    }
  }
  if (twice.empty()) return;
  std::ranges::sort(twice);
  throw Error(ErrorCode::NotADisc, "the loops pass points more than once", std::move(twice));
}

}  // namespace

Patch refine_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   const RefineOptions& options, const Run& run) {
  return refine_patch(points, neighbours, nullptr, loops, {}, options, run);
}

Patch refine_patch(Points points, const Neighbours& neighbours, const Stars* stars,
                   const std::vector<Loop>& loops, std::optional<Triangulation> first,
                   const RefineOptions& options, const Run& run) {
  check_simple(loops, points.size());
  Arena arena(run);  // limits the parallel work below to the run's threads
  return arena.execute([&] {
    run.check_cancel();
    std::vector<UV> uv = outline_on_circle(points, loops);
    const bool map_is_needed = !first || has_map(options.domain);
    if (!first) first = first_of_stars(points, neighbours, stars, loops, uv, run);
    Refined refined = refine_rounds(points, neighbours, loops, std::move(*first), std::move(uv),
                                    map_is_needed ? options.rounds : 1, run);
    std::vector<RefineRound> rounds = std::move(refined.rounds);
    Patch patch = fill_and_map(points, neighbours, std::move(refined), loops, options, run);
    patch.rounds = std::move(rounds);
    return patch;
  });
}

Patch finish_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   std::vector<Triangle> triangles, bool orientable, const RefineOptions& options,
                   const Run& run) {
  RefineOptions without_map = options;
  without_map.domain = Domain::None;
  Arena arena(run);
  return arena.execute([&] {
    Refined refined;
    refined.mesh = triangulation_of(std::move(triangles), static_cast<Index>(points.size()));
    const std::size_t flips = orientable ? flip_edges(points, refined.mesh, run) : 0;
    const EdgeQuality quality = edge_quality(points, refined.mesh, local_spacing(points, neighbours), run);
    Patch patch = fill_and_map(points, neighbours, std::move(refined), loops, without_map, run);
    patch.rounds = {{flips, quality.bad, quality.length}};
    return patch;
  });
}

}  // namespace rimline
