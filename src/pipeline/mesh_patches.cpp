// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mesh_patches.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/filled_holes.h"
#include "pipeline/given_loops.h"
#include "pipeline/orientation.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {
namespace {

void check_loops_bound_something(const std::vector<Loop>& loops) {
  if (!loops.empty()) return;
  throw Error(ErrorCode::NoClosedLoop,
              "no boundary was found, so there is nothing to end the mesh at: the surface is closed, or its "
              "boundary can not be told from the points");
}

// The corners of a square in ids of the arrangement.
std::array<Index, 4> arranged_corners(std::array<Index, 4> corners, const std::vector<Index>& ids) {
  if (corners[0] == none) return corners;
  for (Index& corner : corners) {
    const auto at = std::find(ids.begin(), ids.end(), corner);
    if (at == ids.end()) throw Error(ErrorCode::BadOption, "a corner takes no part", {corner});
    corner = static_cast<Index>(at - ids.begin());
  }
  return corners;
}

RefineOptions refine_options(const Options& options, const PreparedPoints& prepared, bool range_scan) {
  RefineOptions refine;
  refine.domain = options.map.domain;
  refine.rounds = options.mesh.refine_rounds;
  refine.residual = options.map.residual;
  refine.allow_partial = options.mesh.allow_partial;
  refine.leave_beside = range_scan;
  refine.holes = options.mesh.holes;
  refine.fill_points = options.mesh.fill_points;
  refine.corners = arranged_corners(options.map.corners, prepared.ids());
  return refine;
}

ComponentSummary summarize(const PatchReport& patch) {
  ComponentSummary summary;
  summary.points = patch.points;
  summary.triangles = patch.triangles;
  summary.loops = patch.loops;
  summary.bad_share = patch.bad_share;
  summary.suspect = patch.suspect;
  summary.failure = patch.failure;
  if (!patch.rounds.empty()) summary.bad_edges = patch.rounds.back().bad_edges;
  return summary;
}

std::vector<ComponentSummary> summarize_patches(const std::vector<PatchReport>& patches) {
  std::vector<ComponentSummary> components;
  for (const PatchReport& patch : patches) components.push_back(summarize(patch));
  return components;
}

// All systems as one.
MapSummary summarize_maps(const std::vector<PatchReport>& patches) {
  MapSummary all;
  for (const PatchReport& patch : patches) {
    all.unknowns += patch.map.unknowns;
    all.iterations += patch.map.iterations;
    all.residual = std::max(all.residual, patch.map.residual);
  }
  return all;
}

std::vector<std::string> warn_of_patches(const std::vector<PatchReport>& patches, Domain wanted) {
  std::vector<std::string> warnings;
  for (std::size_t at = 0; at < patches.size(); ++at) {
    const PatchReport& patch = patches[at];
    if (patch.suspect) {
      warnings.push_back(fmt::format(
          "component {} is suspect: {:.1f} % of its inner edges are longer than 3 spacings or folded beyond "
          "120 degrees",
          at, 100 * patch.bad_share));
    }
    if (patch.failure.empty() && patch.domain != wanted) {
      warnings.push_back(
          fmt::format("component {} has the disc's map, at the area of the surface: that map has triangles "
                      "turned over already, from which no way leads to a free one",
                      at));
    }
    if (!patch.failure.empty())
      warnings.push_back(fmt::format("component {} was not meshed: {}", at, patch.failure));
  }
  return warnings;
}

std::string why_unmeshed(bool range_scan) {
  return range_scan ? "hang together with no loop, or lie beside the surface that was scanned, and are in no "
                      "triangle"
                    : "hang together with no loop and are in no triangle";
}

MappedMesh with_summaries(MappedMesh mesh, const std::vector<PatchReport>& patches, Domain wanted) {
  mesh.map = summarize_maps(patches);
  mesh.components = summarize_patches(patches);
  mesh.warnings = warn_of_patches(patches, wanted);
  return mesh;
}

}  // namespace

MappedMesh mesh_patches(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                        const Given& given, const Run& run, StageClock& clock) {
  clock.enter(Stage::Refine);
  check_loops_bound_something(found.loops);
  const RefineOptions refine = refine_options(options, prepared, found.range_scan);
  Surface surface = with_ids_of_input(prepared, [&] {
    Surface result =
        refine_surface(prepared.points(), prepared.neighbours, found.loops, found.surface, refine, run);
    if (!given.loops.empty() && !refine.allow_partial) check_reached(result.left_out);
    return result;
  });
  MappedMesh mesh;
  mesh.vertices = prepared.points();
  mesh.vertices.insert(mesh.vertices.end(), surface.added.begin(), surface.added.end());
  mesh.uv = std::move(surface.uv);
  mesh.patch = std::move(surface.patch);
  mesh.triangles = std::move(surface.triangles);
  mesh.triangle_patch = std::move(surface.triangle_patch);
  mesh.filled = std::move(surface.filled);
  mesh.loops = found.loops;
  mesh.label = found.label;
  mesh.unmeshed = why_unmeshed(found.range_scan);
  mesh = with_summaries(std::move(mesh), surface.patches, refine.domain);
  mesh = orient_patches(std::move(mesh), arranged_normals(given, prepared), options.mesh.up, refine.domain);
  return take_out_filled(std::move(mesh), surface.patches);
}

}  // namespace rimline::pipeline
