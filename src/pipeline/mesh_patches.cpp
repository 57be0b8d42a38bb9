// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mesh_patches.h"

#include <algorithm>
#include <cmath>

#include "base/domain_traits.h"
#include "pipeline/charts.h"
#include "pipeline/filled_holes.h"
#include "pipeline/final_check.h"
#include "pipeline/given_loops.h"
#include "pipeline/left_out.h"
#include "pipeline/orientation.h"
#include "pipeline/warnings.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {
namespace {

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
  refine.map_later = traits(options.map.domain).released;
  refine.rounds = options.mesh.refine_rounds;
  refine.residual = options.map.residual;
  refine.handles = options.mesh.handles;
  refine.leave_beside = range_scan;
  refine.holes = options.mesh.holes;
  refine.fill_points = options.mesh.fill_points;
  refine.corners = arranged_corners(options.map.corners, prepared.ids());
  return refine;
}

ComponentSummary summarize(const PatchReport& patch) {
  ComponentSummary summary;
  summary.map = patch.domain;
  summary.orientable = patch.orientable;
  summary.genus = patch.genus;
  summary.repairs = patch.repairs;
  summary.points = patch.points;
  summary.triangles = patch.triangles;
  summary.loops = patch.loops;
  summary.bad_share = patch.bad_share;
  summary.suspect = patch.suspect;
  summary.failure = patch.failure;
  if (!patch.rounds.empty()) summary.bad_edges = patch.rounds.back().bad_edges;
  return summary;
}

// In ids and coordinates of the input.
HandleRepair repair_of_input(HandleRepair repair, const PreparedPoints& prepared) {
  for (Index& v : repair.points) v = prepared.ids()[v];
  repair.place = repair.place + prepared.arrangement.origin;
  return repair;
}

std::vector<ComponentSummary> summarize_patches(const std::vector<PatchReport>& patches,
                                                const PreparedPoints& prepared) {
  std::vector<ComponentSummary> components;
  for (const PatchReport& patch : patches) {
    components.push_back(summarize(patch));
    for (HandleRepair& repair : components.back().repairs)
      repair = repair_of_input(std::move(repair), prepared);
  }
  return components;
}

// Sums over all systems.
MapSummary summarize_maps(const std::vector<PatchReport>& patches) {
  MapSummary all;
  for (const PatchReport& patch : patches) {
    all.unknowns += patch.map.unknowns;
    all.iterations += patch.map.iterations;
    all.residual = std::max(all.residual, patch.map.residual);
  }
  return all;
}

std::string why_unmeshed(bool range_scan) {
  return range_scan ? "lie beside the surface that was scanned, off it, or on a scrap, and are in no triangle"
                    : "lie off the surface or on a scrap of it, and are in no triangle";
}

MappedMesh with_summaries(MappedMesh mesh, const PreparedPoints& prepared,
                          const std::vector<PatchReport>& patches) {
  mesh.map = summarize_maps(patches);
  mesh.components = summarize_patches(patches, prepared);
  mesh.warnings = warn_of_components(patches);
  return mesh;
}

// Rims without a found loop have no fitness yet: eq. (3) on the log score -log(1 - p), as in the method.
std::vector<Loop> rated(std::vector<Loop> loops, const std::vector<float>& probability, double exponent) {
  for (Loop& loop : loops) {
    if (loop.fitness != 0 || probability.empty()) continue;
    double sum = 0;
    for (const Index v : loop.points) sum -= std::log1p(-std::min(0.999999, double{probability[v]}));
    loop.fitness = sum / std::pow(static_cast<double>(loop.points.size()), exponent);
  }
  return loops;
}

MappedMesh with_warnings_of_maps(MappedMesh mesh, Domain wanted) {
  for (std::string& warning : warn_of_maps(mesh.components, wanted))
    mesh.warnings.push_back(std::move(warning));
  return mesh;
}

}  // namespace

MappedMesh mesh_patches(const PreparedPoints& prepared, const FoundLoops& found, const Options& options,
                        const Given& given, const Run& run, StageClock& clock) {
  clock.enter(Stage::Refine);
  const RefineOptions refine = refine_options(options, prepared, found.range_scan);
  Surface surface = with_ids_of_input(prepared, [&] {
    return refine_surface(prepared.points(), prepared.neighbours, found.loops, found.surface, refine, run);
  });
  MappedMesh mesh;
  mesh.vertices = prepared.places();
  mesh.vertices.insert(mesh.vertices.end(), surface.added.begin(), surface.added.end());
  mesh.uv = std::move(surface.uv);
  mesh.patch = std::move(surface.patch);
  mesh.triangles = std::move(surface.triangles);
  mesh.triangle_patch = std::move(surface.triangle_patch);
  mesh.filled = std::move(surface.filled);
  mesh.loops = rated(std::move(surface.loops), found.probability, options.loops.length_exponent);
  mesh.label = label_boundary(found.label, mesh.loops);
  mesh.unmeshed = why_unmeshed(found.range_scan);
  mesh.left_out = describe_left_out(prepared, surface);
  mesh = with_summaries(std::move(mesh), prepared, surface.patches);
  mesh = orient_patches(std::move(mesh), arranged_normals(given, prepared), options.mesh.up, refine.domain);
  mesh = checked(take_out_filled(std::move(mesh), surface.patches), prepared, run);
  return with_warnings_of_maps(map_charts(std::move(mesh), options.map, run), options.map.domain);
}

}  // namespace rimline::pipeline
