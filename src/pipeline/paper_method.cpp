// SPDX-License-Identifier: GPL-3.0-or-later
// Sections 3 and 5 of the paper: one loop, the disc, its Delaunay triangulation.
#include <fmt/format.h>

#include <algorithm>

#include "pipeline/given_loops.h"
#include "pipeline/loop_kinds.h"
#include "pipeline/method.h"
#include "pipeline/orientation.h"
#include "rimline/delaunay.h"
#include "rimline/find_genetic_loop.h"
#include "rimline/map_to_disc.h"

namespace rimline::pipeline {
namespace {

std::vector<std::string> warn_of_bound(const SearchSummary& search, const BoundaryScores& scores,
                                       const LoopOptions& options) {
  if (!search.bound_hit) return {};
  return {
      fmt::format("the search for closed paths stopped at its bound of {} steps after {} of {} "
                  "candidates; raise max_path_steps to search them all",
                  options.max_path_steps, search.starts,
                  std::count(scores.candidate.begin(), scores.candidate.end(), 1))};
}

// Warns where the loop does not come from the fittest chromosome.
std::vector<std::string> warn_of_source(const SearchSummary& search) {
  switch (search.loop_from) {
    case LoopSource::Fittest: return {};
    case LoopSource::Later:
      return {
          fmt::format("the loop is that of a later chromosome: the points of the {} fitter ones have no loop "
                      "that goes round their band, since crossover broke them",
                      search.winner_rank)};
    case LoopSource::InitialPath:
      return {
          fmt::format("the loop is that of initial path {} of {}: no chromosome that the search kept has a "
                      "loop that goes round its band",
                      search.winner_rank + 1, search.population)};
  }
  return {};
}

// Section 3, Algorithms 3.1 and 3.2.
FoundLoops find_loop(const PreparedPoints& prepared, const BoundaryScores& scores, const Options& options,
                     const Given& given, const Run& run, StageClock& clock) {
  clock.enter(Stage::Loops);
  FoundLoops found;
  if (!given.loops.empty()) {
    found.loops = with_one_outer_loop(arrange_loops(given.loops, prepared, scores, options.loops), prepared);
    return found;
  }
  GeneticLoop genetic = with_ids_of_input(prepared, [&] {
    return find_genetic_loop(prepared.points(), prepared.neighbours, scores, options.loops, run);
  });
  found.warnings = warn_of_bound(genetic.search, scores, options.loops);
  for (std::string& warning : warn_of_source(genetic.search)) found.warnings.push_back(std::move(warning));
  found.loops = {std::move(genetic.loop)};
  found.search = std::move(genetic.search);
  found.winner = std::move(genetic.winner);
  found.history = std::move(genetic.history);
  return found;
}

const Loop& longest_outer(const std::vector<Loop>& loops) {
  return *std::max_element(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::pair(a.kind == LoopKind::Outer, a.length) < std::pair(b.kind == LoopKind::Outer, b.length);
  });
}

// Section 5, eq. (4): the rim of the disc is the longest outer loop; other loops are filled (section 6).
MappedMesh map_to_the_disc(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                           const Given&, const Run& run, StageClock& clock) {
  clock.enter(Stage::Parameterize);
  const std::vector<Index>& rim = longest_outer(found.loops).points;
  DiscMap disc = with_ids_of_input(
      prepared, [&] { return map_to_disc(prepared.points(), prepared.neighbours, rim, options.map, run); });
  MappedMesh mesh;
  mesh.vertices = prepared.points();
  mesh.uv = std::move(disc.uv);
  mesh.loops = found.loops;
  mesh.map = disc.summary;
  mesh.unmeshed = "fell on others in the plane and are in no triangle";
  return mesh;
}

// Section 5: the Delaunay triangulation of the parameter points, lifted to the points.
MappedMesh mesh_the_disc(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                         const Given& given, const Run& run, StageClock& clock) {
  MappedMesh mesh = map_to_the_disc(prepared, found, options, given, run, clock);
  clock.enter(Stage::Triangulate);
  mesh.triangles = delaunay(mesh.uv, run);
  return orient_whole(std::move(mesh), arranged_normals(given, prepared), options.mesh.up);
}

}  // namespace

const Method& method_of_the_paper() {
  static constexpr Method method{find_loop, map_to_the_disc, mesh_the_disc};
  return method;
}

}  // namespace rimline::pipeline
