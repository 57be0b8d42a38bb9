// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/map_and_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/filled_holes.h"
#include "pipeline/given_loops.h"
#include "pipeline/orientation.h"
#include "rimline/parameterize.h"
#include "rimline/refine.h"
#include "rimline/triangulate.h"

namespace rimline::pipeline {
namespace {

const Loop& longest_outer(const std::vector<Loop>& loops) {
  return *std::max_element(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::pair(a.kind == LoopKind::Outer, a.length) < std::pair(b.kind == LoopKind::Outer, b.length);
  });
}

void check_loops_bound_something(const std::vector<Loop>& loops) {
  if (!loops.empty()) return;
  throw Error(ErrorCode::NoClosedLoop,
              "no boundary was found, so there is nothing to end the mesh at: the surface is closed, or its "
              "boundary can not be told from the points");
}

void report_patch(Report& report, const PatchReport& patch, Domain wanted) {
  report.map.unknowns += patch.map.unknowns;
  report.map.iterations += patch.map.iterations;
  report.map.residual = std::max(report.map.residual, patch.map.residual);
  ComponentSummary summary;
  summary.points = patch.points;
  summary.triangles = patch.triangles;
  summary.loops = patch.loops;
  summary.bad_share = patch.bad_share;
  summary.suspect = patch.suspect;
  summary.failure = patch.failure;
  if (!patch.rounds.empty()) summary.bad_edges = patch.rounds.back().bad_edges;
  const std::size_t at = report.components.size();
  if (patch.suspect) {
    report.warnings.push_back(fmt::format(
        "component {} is suspect: {:.1f} % of its inner edges are longer than 3 spacings or folded beyond "
        "120 degrees",
        at, 100 * patch.bad_share));
  }
  if (patch.failure.empty() && patch.domain != wanted) {
    report.warnings.push_back(
        fmt::format("component {} has the disc's map, at the area of the surface: that map has triangles "
                    "turned over already, from which no way leads to a free one",
                    at));
  }
  if (!patch.failure.empty()) {
    report.warnings.push_back(fmt::format("component {} was not meshed: {}", at, patch.failure));
  }
  report.components.push_back(std::move(summary));
}

// The corners of a square in ids of the arrangement.
std::array<Index, 4> arranged_corners(const Work& work) {
  std::array<Index, 4> corners = work.options.map.corners;
  if (corners[0] == none) return corners;
  for (Index& corner : corners) {
    const auto& ids = work.arrangement.ids;
    const auto at = std::find(ids.begin(), ids.end(), corner);
    if (at == ids.end()) throw Error(ErrorCode::BadOption, "a corner takes no part", {corner});
    corner = static_cast<Index>(at - ids.begin());
  }
  return corners;
}

}  // namespace

void map_to_the_disc(Work& work) {
  work.clock.enter(Stage::Parameterize);
  DiscMap found = translate_errors(work, [&] {
    return map_to_disc(work.arrangement.points, work.neighbours, longest_outer(work.loops).points,
                       work.options.map, work.run);
  });
  work.uv = std::move(found.uv);
  work.vertices = work.arrangement.points;
  work.report.has_map = true;
  work.report.map = found.summary;
}

void triangulate_the_disc(Work& work) {
  work.clock.enter(Stage::Triangulate);
  work.triangles = delaunay(work.uv, work.run);
  orient_whole(work);
}

void mesh_patches(Work& work) {
  work.clock.enter(Stage::Refine);
  check_loops_bound_something(work.loops);
  RefineOptions refine;
  refine.domain = work.options.map.domain;
  refine.rounds = work.options.mesh.refine_rounds;
  refine.residual = work.options.map.residual;
  refine.allow_partial = work.options.mesh.allow_partial;
  refine.leave_beside = work.range_scan;
  refine.holes = work.options.mesh.holes;
  refine.fill_points = work.options.mesh.fill_points;
  refine.corners = arranged_corners(work);
  Surface surface = translate_errors(work, [&] {
    Surface found =
        refine_surface(work.arrangement.points, work.neighbours, work.loops, work.surveyed, refine, work.run);
    if (!work.given.loops.empty() && !refine.allow_partial) check_reached(found.left_out);
    return found;
  });
  work.uv = std::move(surface.uv);
  work.triangles = std::move(surface.triangles);
  work.patch = std::move(surface.patch);
  work.triangle_patch = std::move(surface.triangle_patch);
  work.filled = std::move(surface.filled);
  work.vertices = work.arrangement.points;
  work.vertices.insert(work.vertices.end(), surface.added.begin(), surface.added.end());
  work.report.has_map = true;
  for (const PatchReport& patch : surface.patches) report_patch(work.report, patch, work.options.map.domain);
  orient_patches(work, surface.patches.size());
  take_out_filled(work, surface.patches);
}

}  // namespace rimline::pipeline
